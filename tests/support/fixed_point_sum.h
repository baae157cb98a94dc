#pragma once

#include <bit>
#include <cstdint>

#include "contact/fixed_point.h"

namespace repose::test {

/// One contribution to a fixed-point sum: adds an offset value (to_fixed_point); false, and nothing added, when it is
/// out of range.
inline bool add_fixed_point(double offset_value, std::int64_t& sum) {
  const auto bits = std::bit_cast<std::uint64_t>(offset_value);
  const bool in_range = in_fixed_point_range(bits ^ fixed_point_offset_bits);
  if (in_range) sum += static_cast<std::int64_t>(bits - fixed_point_offset_bits);
  return in_range;
}

}  // namespace repose::test
