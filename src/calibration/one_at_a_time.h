#pragma once

#include <span>

namespace repose {

/// Runs of one point with different seeds.
struct SeedSample {
  double mean = 0.0;       ///< NaN without a run
  double deviation = 0.0;  ///< from seed to seed; NaN with fewer than two
  double runs = 0.0;       ///< that have a value
};

/// Of the values that are not NaN.
SeedSample seed_sample(std::span<const double> values);

/// What an observable does when one parameter goes from a lower to an upper value and all others stay (thesis 3.3.3).
struct OneAtATimeEffect {
  SeedSample lower, upper;
  double effect = 0.0;          ///< upper less lower
  double standard_error = 0.0;  ///< of it, by the scatter of the seeds at both (C.19); NaN when that is not known
};

OneAtATimeEffect one_at_a_time_effect(std::span<const double> at_lower, std::span<const double> at_upper);

}  // namespace repose
