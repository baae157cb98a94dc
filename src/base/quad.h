#pragma once

#include <cmath>
#include <cstdint>

#include "base/vec3.h"

namespace repose {

/// Four doubles as one vector value; the compiler maps it to the registers of the instruction set at hand. In memory
/// they are part of columns, records and sums, aligned to 32 bytes: there they go by the names that may alias.
using Quad = double __attribute__((vector_size(32)));
using QuadInt = std::int64_t __attribute__((vector_size(32)));
using QuadBits = std::uint64_t __attribute__((vector_size(32)));
using QuadInMemory = double __attribute__((vector_size(32), may_alias));
using QuadIntInMemory = std::int64_t __attribute__((vector_size(32), may_alias));
using QuadBitsInMemory = std::uint64_t __attribute__((vector_size(32), may_alias));

/// The vectors of four lanes.
using QuadVec3 = Vector3<Quad>;

// The counterparts of vec3.h. The compiler makes one instruction of each.
[[gnu::always_inline]] inline Quad square_root(const Quad& q) {
  return Quad{std::sqrt(q[0]), std::sqrt(q[1]), std::sqrt(q[2]), std::sqrt(q[3])};
}
[[gnu::always_inline]] inline Quad magnitude(const Quad& q) {
  return reinterpret_cast<Quad>(reinterpret_cast<QuadBits>(q) & 0x7fffffffffffffff);
}
[[gnu::always_inline]] inline Quad select(const QuadInt& condition, const Quad& yes, const Quad& no) {
  return condition ? yes : no;
}
[[gnu::always_inline]] inline Quad load(const double* column) { return *reinterpret_cast<const QuadInMemory*>(column); }
[[gnu::always_inline]] inline void store(const Quad& q, double* column) {
  *reinterpret_cast<QuadInMemory*>(column) = q;
}

/// How many lanes a comparison holds in, of one or of several added up: each is minus one.
[[gnu::always_inline]] inline std::int64_t count(const QuadInt& comparisons) {
  return -(comparisons[0] + comparisons[1] + comparisons[2] + comparisons[3]);
}

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
[[gnu::always_inline]] inline Quad to_double(const QuadInt& value) {
  constexpr std::uint64_t low_exponent = 0x4330000000000000;   // 2^52
  constexpr std::uint64_t high_exponent = 0x4530000000000000;  // 2^84
  constexpr double shift = 0x1p84 + 0x1p63 + 0x1p52;
  const auto bits = reinterpret_cast<QuadBits>(value);
  const QuadBits low = (bits & 0xffffffff) | low_exponent;
  const QuadBits high = ((bits ^ 0x8000000000000000) >> 32) | high_exponent;
  return (reinterpret_cast<Quad>(high) - shift) + reinterpret_cast<Quad>(low);
}

}  // namespace repose
