#pragma once

/// Student's distribution, for intervals and tests. The number of degrees of freedom need not be whole.
namespace repose::thermal {

/// The regularised incomplete beta function I_x(a, b) for a, b > 0 and 0 <= x <= 1, within 1e-13: the continued
/// fraction of the NIST Digital Library of Mathematical Functions, https://dlmf.nist.gov/8.17.E22.
double incomplete_beta(double a, double b, double x);

/// P(T <= t).
double student_cdf(double t, double degrees);

/// The t with P(T <= t) = p, 0 < p < 1.
double student_quantile(double p, double degrees);

}  // namespace repose::thermal
