#pragma once

#include <cstdint>

#include "deck/schema_types.h"
#include "thermal/air.h"

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

}  // namespace repose::thermal
