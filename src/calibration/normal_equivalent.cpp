#include "calibration/normal_equivalent.h"

#include <cmath>

namespace repose {
namespace {

bool differs(double freedom) { return std::isfinite(freedom) && freedom <= 1e8; }

}  // namespace

double normal_equivalent(double t, double freedom) {
  if (!differs(freedom)) return t;
  const double correction = (8.0 * freedom + 1.0) / (8.0 * freedom + 3.0);
  return std::copysign(correction * std::sqrt(freedom * std::log1p(t * t / freedom)), t);  // (C.14)
}

double log_slope_of_normal_equivalent(double t, double freedom) {
  if (!differs(freedom)) return 0.0;
  const double correction = (8.0 * freedom + 1.0) / (8.0 * freedom + 3.0);
  const double share = t * t / freedom;
  const double growth = std::log1p(share);  // share near t = 0, where their ratio is 1
  const double shape = share > 1e-12 ? 0.5 * std::log(share / growth) : 0.0;
  return std::log(correction) + shape - growth;
}

}  // namespace repose
