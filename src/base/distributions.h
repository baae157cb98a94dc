#pragma once

/// Distributions for intervals and tests, by Boost.Math. The number of degrees of freedom need not be whole. What is no
/// valid argument gives NaN.
namespace repose {

/// Share of a chi-squared distribution with `freedom` degrees of freedom below x.
double chi_squared_below(double x, double freedom);

/// The x with this share (0 to 1, excluded) below it.
double chi_squared_quantile(double share, double freedom);

/// Share of the standard normal distribution below x.
double normal_below(double x);

/// The x with this share (0 to 1, excluded) below it.
double normal_quantile(double share);

/// P(T <= t) of Student's distribution.
double student_cdf(double t, double freedom);

/// The t with P(T <= t) = p, 0 < p < 1.
double student_quantile(double p, double freedom);

}  // namespace repose
