#pragma once

#include <bit>
#include <cstdint>

#include "base/quad.h"

namespace repose {

/// The real number whose high 32 bits are those of `x` times `share` / 2^32, plus `bias`.
[[gnu::always_inline]] inline double scaled_exponent(double x, std::uint64_t share, std::uint64_t bias) {
  const std::uint64_t high = std::bit_cast<std::uint64_t>(x) >> 32;
  return std::bit_cast<double>((((high * share) >> 32) + bias) << 32);
}
template <Lanes Real>
[[gnu::always_inline]] inline Real scaled_exponent(const Real& x, std::uint64_t share, std::uint64_t bias) {
  const LaneBits<Real> high = reinterpret_cast<LaneBits<Real>>(x) >> 32;
  return reinterpret_cast<Real>((((high * share) >> 32) + bias) << 32);
}

/// The third or fifth root of `x`, which must be between 1e-60 and 1e60, within 5e-16 of it. By arithmetic alone, so
/// that it has the same bits everywhere, for one number or for one in each lane: a start within 10 % by a share of the
/// exponent, and Newton's method.
template <int n, class Real>
[[gnu::always_inline]] inline Real odd_root(const Real& x) {
  static_assert(n == 3 || n == 5);
  constexpr std::uint64_t share = (std::uint64_t{1} << 32) / n;
  constexpr std::uint64_t bias = std::uint64_t{0x3fef8000} - ((std::uint64_t{0x3fef8000} * share) >> 32);
  Real y = scaled_exponent(x, share, bias);
  for (int k = 0; k < 6; ++k) {
    const Real y_2 = y * y;
    const Real power = n == 3 ? y_2 : y_2 * y_2;
    y = y + (1.0 / n) * (x / power - y);
  }
  return y;
}

}  // namespace repose
