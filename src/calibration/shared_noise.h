#pragma once

#include <cmath>
#include <vector>

#include "calibration/linear_algebra.h"
#include "calibration/replicates.h"

namespace repose {

/// What the seed of a run does to two observables at once: a run that lets more grains out also builds a higher pile.
/// Then the errors of the two surfaces are not independent.
struct SharedNoise {
  double correlation = 0.0;  ///< of the scatter of one run
  /// Of each point of the one the same point of the other (-1: it has none), and the covariance of the means there over
  /// that of one run.
  std::vector<Index> partner;
  Vector share;

  /// Covariance of two surfaces that take the means of their points with these weights (C.11); variances of one run.
  double covariance(const Vector& weights_a, double variance_a, const Vector& weights_b, double variance_b) const {
    Vector linked(share.size());
    for (Index i = 0; i < share.size(); ++i) {
      const Index other = partner[static_cast<std::size_t>(i)];
      linked[i] = other < 0 ? 0.0 : share[i] * weights_b[other];
    }
    return correlation * std::sqrt(variance_a * variance_b) * weights_a.dot(linked);
  }
};

/// From the runs that have both (C.10); no correlation when the seeds of these say too little of it.
SharedNoise shared_noise(const Replicates& a, const Replicates& b);

}  // namespace repose
