#include "calibration/one_at_a_time.h"

#include <cmath>
#include <limits>

namespace repose {

SeedSample seed_sample(std::span<const double> values) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  SeedSample s;
  double sum = 0.0;
  for (const double value : values) {
    if (std::isnan(value)) continue;
    sum += value;
    s.runs += 1.0;
  }
  s.mean = s.runs > 0.0 ? sum / s.runs : unknown;
  double squares = 0.0;
  for (const double value : values) {
    if (!std::isnan(value)) squares += (value - s.mean) * (value - s.mean);
  }
  s.deviation = s.runs > 1.0 ? std::sqrt(squares / (s.runs - 1.0)) : unknown;
  return s;
}

OneAtATimeEffect one_at_a_time_effect(std::span<const double> at_lower, std::span<const double> at_upper) {
  OneAtATimeEffect e = {
      .lower = seed_sample(at_lower), .upper = seed_sample(at_upper), .effect = 0, .standard_error = 0};
  e.effect = e.upper.mean - e.lower.mean;
  e.standard_error = std::sqrt(e.lower.deviation * e.lower.deviation / e.lower.runs +
                               e.upper.deviation * e.upper.deviation / e.upper.runs);  // (C.19)
  return e;
}

}  // namespace repose
