#pragma once

#include <bit>
#include <cstdint>

#include "scene/particles/particles.h"

namespace repose {

/// Adding 1.5 * 2^52 to a double of magnitude below 2^51 leaves it, rounded to the nearest integer, in the low bits of
/// the result: a conversion that every vector instruction set can do. A larger magnitude, or NaN, shows in the
/// exponent.
inline constexpr double fixed_point_offset = 6755399441055744.0;
inline constexpr auto fixed_point_offset_bits = std::bit_cast<std::uint64_t>(fixed_point_offset);

/// The offset value of a double or of a Quad of them; its integer is its bits less fixed_point_offset_bits.
template <class Real>
[[gnu::always_inline]] constexpr Real to_fixed_point(const Real& value, const Real& scale) {
  return value * scale + fixed_point_offset;
}
/// The same of -value, bit for bit, for one operation less.
template <class Real>
[[gnu::always_inline]] constexpr Real to_fixed_point_negated(const Real& value, const Real& scale) {
  return fixed_point_offset - value * scale;
}

/// Whether offset values were in range whose bits, each by exclusive or with fixed_point_offset_bits, are in
/// `difference`.
constexpr bool in_fixed_point_range(std::uint64_t difference) { return (difference >> fixed_point_bits) == 0; }

}  // namespace repose
