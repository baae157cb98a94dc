#include "calibration/normal_equivalent.h"

#include <cmath>

namespace repose {

double normal_equivalent(double t, double freedom) {
  if (!std::isfinite(freedom) || freedom > 1e8) return t;
  const double correction = (8.0 * freedom + 1.0) / (8.0 * freedom + 3.0);
  return std::copysign(correction * std::sqrt(freedom * std::log1p(t * t / freedom)), t);  // (C.14)
}

}  // namespace repose
