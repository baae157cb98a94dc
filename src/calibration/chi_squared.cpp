#include "calibration/chi_squared.h"

#include <cmath>

namespace repose {
namespace {

/// Regularised lower incomplete gamma function P(a, x) by its power series: all terms positive, so no digits are lost.
double gamma_below(double a, double x) {
  if (x <= 0.0) return 0.0;
  double term = 1.0 / a;
  double sum = term;
  for (double n = a + 1.0; term > 1e-17 * sum; n += 1.0) {
    term *= x / n;
    sum += term;
  }
  return sum * std::exp(a * std::log(x) - x - std::lgamma(a));
}

}  // namespace

double chi_squared_below(double x, double freedom) { return gamma_below(0.5 * freedom, 0.5 * x); }

double chi_squared_quantile(double share, double freedom) {
  double lower = 0.0;
  double upper = freedom;
  while (chi_squared_below(upper, freedom) < share) upper *= 2.0;
  while (upper - lower > 1e-11 * upper) {
    const double middle = 0.5 * (lower + upper);
    (chi_squared_below(middle, freedom) < share ? lower : upper) = middle;
  }
  return upper;
}

double normal_equivalent(double t, double freedom) {
  if (!std::isfinite(freedom) || freedom > 1e8) return t;
  const double correction = (8.0 * freedom + 1.0) / (8.0 * freedom + 3.0);
  return std::copysign(correction * std::sqrt(freedom * std::log1p(t * t / freedom)), t);  // (C.14)
}

}  // namespace repose
