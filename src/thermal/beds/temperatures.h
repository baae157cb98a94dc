#pragma once

#include <cstdint>
#include <vector>

#include "deck/key.h"
#include "deck/read_described.h"
#include "heat/air.h"

namespace repose::thermal {

/// Temperatures at which a tool evaluates, evenly spaced.
struct TemperatureRange {
  double min = 298.15;  ///< K
  double max = 973.15;  ///< K
  std::int64_t count = 10;
};

/// The keys of [temperature]; the range is that of the correlations for air.
template <class V>
void describe(V& v, TemperatureRange& t) {
  const Range range = from_to(air_min_temperature, air_max_temperature);
  v("min", t.min, Unit::kelvin, range, optional, "lowest temperature");
  v("max", t.max, Unit::kelvin, range, optional, "highest temperature");
  v("count", t.count, Unit::none, from_to(1, 1000), optional, "number of temperatures, evenly spaced");
}

inline void check_range(const TemperatureRange& t, DeckErrors& errors) {
  if (t.max < t.min) errors.add("temperature.max", "\"max\" of [temperature] must not be below \"min\"");
}

/// From the lowest to the highest, both included; a single one is the lowest. K.
inline std::vector<double> temperatures_of(const TemperatureRange& t) {
  std::vector<double> temperatures;
  for (std::int64_t i = 0; i < t.count; ++i) {
    const double share = t.count > 1 ? static_cast<double>(i) / static_cast<double>(t.count - 1) : 0.0;
    temperatures.push_back(t.min + share * (t.max - t.min));
  }
  return temperatures;
}

}  // namespace repose::thermal
