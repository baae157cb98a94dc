#pragma once

#include <bit>
#include <cstdint>

#include "scene/particles.h"

namespace repose {

/// Adding 1.5 * 2^52 to a double of magnitude below 2^51 leaves it, rounded to the nearest integer, in the low bits of
/// the result: a conversion that every vector instruction set can do. A larger magnitude, or NaN, shows in the
/// exponent.
inline constexpr double fixed_point_offset = 6755399441055744.0;
inline constexpr std::int64_t fixed_point_offset_bits = std::bit_cast<std::int64_t>(fixed_point_offset);

constexpr double to_fixed_point(double value, double scale) { return value * scale + fixed_point_offset; }

/// The same of -value, bit for bit, for one operation less.
constexpr double to_fixed_point_negated(double value, double scale) { return fixed_point_offset - value * scale; }

/// Adds an offset value (to_fixed_point) to a sum; false, and nothing added, when it is out of range.
constexpr bool add_fixed_point(double offset_value, std::int64_t& sum) {
  const auto bits = std::bit_cast<std::int64_t>(offset_value);
  const bool in_range = ((bits ^ fixed_point_offset_bits) >> fixed_point_bits) == 0;
  if (in_range) sum += bits - fixed_point_offset_bits;
  return in_range;
}

}  // namespace repose
