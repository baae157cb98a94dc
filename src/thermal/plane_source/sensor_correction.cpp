#include "thermal/plane_source/sensor_correction.h"

#include <algorithm>
#include <cmath>

namespace repose::thermal {

double error_percent(double value, double reference) { return 100.0 * std::abs(value / reference - 1.0); }

ErrorInterval possible_errors(double value, double reference, double half_unit) {
  const double low = (value - half_unit) / (reference + half_unit) - 1.0;
  const double high = (value + half_unit) / (reference - half_unit) - 1.0;
  const double nearest = low <= 0.0 && high >= 0.0 ? 0.0 : std::min(std::abs(low), std::abs(high));
  return {100.0 * nearest, 100.0 * std::max(std::abs(low), std::abs(high))};
}

Measured sensor_bias(const Measured& mica, const Measured& kapton) {
  return {mica.value - kapton.value, std::hypot(mica.deviation, kapton.deviation)};  // (T.8, T.10)
}

Measured corrected(const Measured& reading, const Measured& bias) {
  return {reading.value - bias.value, std::hypot(reading.deviation, bias.deviation)};  // (T.9, T.10)
}

}  // namespace repose::thermal
