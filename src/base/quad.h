#pragma once

#include <cstdint>

namespace repose {

/// Four doubles as one vector value; the compiler maps it to the registers of the instruction set at hand.
/// It may alias the columns and records that it is loaded from and stored to, which must be aligned to 32 bytes.
using Quad = double __attribute__((vector_size(32), may_alias));
using QuadInt = std::int64_t __attribute__((vector_size(32), may_alias));
using QuadBits = std::uint64_t __attribute__((vector_size(32), may_alias));

/// Rows become columns, in place. Everything is inlined: the type has no calling convention shared by all vector
/// levels.
[[gnu::always_inline]] inline void transpose(Quad& a, Quad& b, Quad& c, Quad& d) {
  const Quad ab_even = __builtin_shuffle(a, b, QuadInt{0, 4, 2, 6});
  const Quad ab_odd = __builtin_shuffle(a, b, QuadInt{1, 5, 3, 7});
  const Quad cd_even = __builtin_shuffle(c, d, QuadInt{0, 4, 2, 6});
  const Quad cd_odd = __builtin_shuffle(c, d, QuadInt{1, 5, 3, 7});
  a = __builtin_shuffle(ab_even, cd_even, QuadInt{0, 1, 4, 5});
  b = __builtin_shuffle(ab_odd, cd_odd, QuadInt{0, 1, 4, 5});
  c = __builtin_shuffle(ab_even, cd_even, QuadInt{2, 3, 6, 7});
  d = __builtin_shuffle(ab_odd, cd_odd, QuadInt{2, 3, 6, 7});
}

/// Each element as static_cast<double> would convert it, without an instruction for that (AVX2 has none): both halves
/// as the low bits of doubles of known exponent, put together by the one addition that rounds.
[[gnu::always_inline]] inline void to_double(const QuadInt& value, Quad& result) {
  constexpr std::uint64_t low_exponent = 0x4330000000000000;   // 2^52
  constexpr std::uint64_t high_exponent = 0x4530000000000000;  // 2^84
  constexpr double shift = 0x1p84 + 0x1p63 + 0x1p52;
  const auto bits = reinterpret_cast<QuadBits>(value);
  const QuadBits low = (bits & 0xffffffff) | low_exponent;
  const QuadBits high = ((bits ^ 0x8000000000000000) >> 32) | high_exponent;
  result = (reinterpret_cast<Quad>(high) - shift) + reinterpret_cast<Quad>(low);
}

}  // namespace repose
