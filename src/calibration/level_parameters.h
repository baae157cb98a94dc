#pragma once

#include <cmath>

#include "calibration/linear_algebra.h"

namespace repose {

/// What shapes one level of a process over levels, in the standardised units of that level.
struct LevelParameters {
  double rho = 0.0;  ///< what the level takes of the one below; 0 at the lowest
  Vector lengths;    ///< of the kernel of what the level adds, in units of the box
  double added_variance = 0.0;
  Vector noise;  ///< ln of the variance of one run: in the middle of the box, and its slopes over the box (C.24)

  static constexpr double least_noise = 1e-9;  ///< keeps covariances of noise-free values positive definite

  /// Variance of one run at a point.
  double noise_variance(const Vector& point) const {
    return least_noise + std::exp(noise[0] + noise.tail(point.size()).dot(Vector(point.array() - 0.5)));
  }
};

}  // namespace repose
