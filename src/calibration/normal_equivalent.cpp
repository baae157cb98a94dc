#include "calibration/normal_equivalent.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/distributions.h"

namespace repose {
namespace {

constexpr double exact_up_to = 5.0;     // degrees of freedom
constexpr double least_share = 1e-290;  // of a tail; below it doubles end
constexpr double nearly_none = 1e-7;    // a t at which the share is 1/2 but for rounding
constexpr double log_two_pi = 1.8378770664093453;

bool differs(double freedom) { return std::isfinite(freedom) && freedom <= 1e8; }

double by_wallace(double t, double freedom) {
  const double correction = (8.0 * freedom + 1.0) / (8.0 * freedom + 3.0);
  return std::copysign(correction * std::sqrt(freedom * std::log1p(t * t / freedom)), t);
}

double log_slope_by_wallace(double t, double freedom) {
  const double correction = (8.0 * freedom + 1.0) / (8.0 * freedom + 3.0);
  const double share = t * t / freedom;
  const double growth = std::log1p(share);  // share near t = 0, where their ratio is 1
  const double shape = share > 1e-12 ? 0.5 * std::log(share / growth) : 0.0;
  return std::log(correction) + shape - growth;
}

double log_density_of_student(double t, double freedom) {
  return std::lgamma(0.5 * (freedom + 1.0)) - std::lgamma(0.5 * freedom) - 0.5 * std::log(freedom * std::numbers::pi) -
         0.5 * (freedom + 1.0) * std::log1p(t * t / freedom);
}

double log_slope_by_shares(double t, double z, double freedom) {
  return log_density_of_student(t, freedom) + 0.5 * (z * z + log_two_pi);
}

double by_shares(double t, double freedom, double tail) {
  if (std::fabs(t) < nearly_none) return t * std::exp(log_slope_by_shares(0.0, 0.0, freedom));
  return std::copysign(normal_quantile(tail), t);
}

/// The exact value and how much of it is taken.
struct Exact {
  double share = 0.0;
  double z = 0.0;
};

Exact exact_at(double t, double freedom) {
  if (freedom >= exact_up_to + 1.0) return {};
  const double tail = student_cdf(-std::fabs(t), freedom);
  if (!(tail > least_share)) return {};
  return {std::min(1.0, exact_up_to + 1.0 - freedom), by_shares(t, freedom, tail)};
}

}  // namespace

double normal_equivalent(double t, double freedom) {
  if (!differs(freedom)) return t;
  const auto [share, z] = exact_at(t, freedom);
  if (share == 0.0) return by_wallace(t, freedom);
  return share * z + (1.0 - share) * by_wallace(t, freedom);  // (C.14)
}

double log_slope_of_normal_equivalent(double t, double freedom) {
  if (!differs(freedom)) return 0.0;
  const auto [share, z] = exact_at(t, freedom);
  if (share == 0.0) return log_slope_by_wallace(t, freedom);
  const double slope = std::exp(log_slope_by_shares(t, z, freedom));
  return std::log(share * slope + (1.0 - share) * std::exp(log_slope_by_wallace(t, freedom)));
}

}  // namespace repose
