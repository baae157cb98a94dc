#pragma once

#include <cmath>

#include "calibration/linear_algebra.h"
#include "calibration/replicates.h"

namespace repose {

/// What the seed of a run does to two observables at once: a run that lets more grains out also builds a higher pile.
/// Then the errors of the two surfaces are not independent.
struct SharedNoise {
  double correlation = 0.0;  ///< of the scatter of one run
  Matrix links;  ///< covariance of the means at points of one (down) and of the other (across), over that of one run

  /// Covariance of two surfaces that take the means of their points with these weights (C.11); variances of one run.
  double covariance(const Vector& weights_a, double variance_a, const Vector& weights_b, double variance_b) const {
    return correlation * std::sqrt(variance_a * variance_b) * weights_a.dot(links * weights_b);
  }
};

/// From the runs that have both; no correlation when the seeds say too little of it.
SharedNoise shared_noise(const Replicates& a, const Replicates& b);

}  // namespace repose
