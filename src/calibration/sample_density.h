#pragma once

#include <cstdint>
#include <functional>

#include "calibration/linear_algebra.h"

namespace repose {

/// A density over the unit box: a prior that can be drawn from times a likelihood. Logarithms, each up to a constant;
/// -infinity where the density is 0.
struct BoxDensity {
  std::function<Vector(const Vector& shares)> draw;  ///< a point of the prior from numbers uniform in [0, 1)
  std::function<double(const Vector& point)> log_prior;
  std::function<double(const Vector& point)> log_likelihood;
};

struct SamplePlan {
  Index walkers = 1000;
  Index moves = 4;     ///< of each walker at each power of the likelihood on the way
  Index settling = 8;  ///< and at the whole likelihood before the first is kept
  Index kept = 4;      ///< samples of each walker
  Index apart = 8;     ///< moves from one to the next
  std::uint64_t seed = 1;
};

struct Samples {
  Matrix points;            ///< a row each
  Vector log_density;       ///< prior times likelihood
  Index stages = 0;         ///< powers of the likelihood
  double acceptance = 0.0;  ///< share of the moves at the whole likelihood that were taken
};

/// Draws from a density, all alike: walkers start as draws of the prior, follow the likelihood raised to powers that
/// grow to 1 (Del Moral, Doucet, Jasra 2006, doi:10.1111/j.1467-9868.2006.00553.x), and move by the differences of
/// others (ter Braak 2006, doi:10.1007/s11222-006-8769-1). So several maxima keep their shares, and no step has to be
/// chosen. A function of its arguments alone. DeckError when the density is 0 at all that was drawn of the prior.
Samples sample_density(const BoxDensity& density, Index dimensions, const SamplePlan& plan);

}  // namespace repose
