#pragma once

#include <cmath>
#include <concepts>
#include <cstdint>
#include <type_traits>

#include "base/vec3.h"

namespace repose {

/// Four and eight doubles as one vector value; the compiler maps it to the registers of the instruction set at hand.
using Quad = double __attribute__((vector_size(32)));
using Octet = double __attribute__((vector_size(64)));

/// What the lanes of a vector level are (base/vector_level.h): four, or eight.
template <class Real>
concept Lanes = std::same_as<Real, Quad> || std::same_as<Real, Octet>;
template <Lanes Real>
inline constexpr int lanes_of = static_cast<int>(sizeof(Real) / sizeof(double));
template <int lanes>
using LanesOf = std::conditional_t<lanes == 8, Octet, Quad>;

/// Integers of as many lanes. In memory all are part of columns, records and sums, aligned to 32 or 64 bytes: there
/// they go by the names that may alias.
using QuadInt = std::int64_t __attribute__((vector_size(32)));
using QuadBits = std::uint64_t __attribute__((vector_size(32)));
using QuadInMemory = double __attribute__((vector_size(32), may_alias));
using QuadIntInMemory = std::int64_t __attribute__((vector_size(32), may_alias));
using QuadBitsInMemory = std::uint64_t __attribute__((vector_size(32), may_alias));
using OctetInt = std::int64_t __attribute__((vector_size(64)));
using OctetIntInMemory = std::int64_t __attribute__((vector_size(64), may_alias));
using OctetBits = std::uint64_t __attribute__((vector_size(64)));
using OctetInMemory = double __attribute__((vector_size(64), may_alias));
using OctetBitsInMemory = std::uint64_t __attribute__((vector_size(64), may_alias));

template <Lanes Real>
struct LaneTypes {
  using Int = QuadInt;
  using Bits = QuadBits;
  using InMemory = QuadInMemory;
  using BitsInMemory = QuadBitsInMemory;
};
template <>
struct LaneTypes<Octet> {
  using Int = OctetInt;
  using Bits = OctetBits;
  using InMemory = OctetInMemory;
  using BitsInMemory = OctetBitsInMemory;
};
template <Lanes Real>
using LaneInt = typename LaneTypes<Real>::Int;
template <Lanes Real>
using LaneBits = typename LaneTypes<Real>::Bits;

using QuadVec3 = Vector3<Quad>;

// The counterparts of vec3.h. The compiler makes one instruction of each. Everything is inlined: the types have no
// calling convention shared by all vector levels.
[[gnu::always_inline]] inline Quad square_root(const Quad& q) {
  return Quad{std::sqrt(q[0]), std::sqrt(q[1]), std::sqrt(q[2]), std::sqrt(q[3])};
}
[[gnu::always_inline]] inline Octet square_root(const Octet& o) {
  return Octet{std::sqrt(o[0]), std::sqrt(o[1]), std::sqrt(o[2]), std::sqrt(o[3]),
               std::sqrt(o[4]), std::sqrt(o[5]), std::sqrt(o[6]), std::sqrt(o[7])};
}
template <Lanes Real>
[[gnu::always_inline]] inline Real magnitude(const Real& x) {
  return reinterpret_cast<Real>(reinterpret_cast<LaneBits<Real>>(x) & 0x7fffffffffffffff);
}
template <Lanes Real>
[[gnu::always_inline]] inline Real select(const LaneInt<Real>& condition, const Real& yes, const Real& no) {
  return condition ? yes : no;
}
template <Lanes Real>
[[gnu::always_inline]] inline Real load(const double* column) {
  return *reinterpret_cast<const typename LaneTypes<Real>::InMemory*>(column);
}
template <Lanes Real>
[[gnu::always_inline]] inline void store(const Real& x, double* column) {
  *reinterpret_cast<typename LaneTypes<Real>::InMemory*>(column) = x;
}

/// 0, 1, 2 ...
template <Lanes Real>
[[gnu::always_inline]] inline LaneInt<Real> lane_numbers() {
  LaneInt<Real> numbers = {};
  for (int k = 0; k < lanes_of<Real>; ++k) numbers[k] = k;
  return numbers;
}
/// The bits that any lane has.
[[gnu::always_inline]] inline std::uint64_t any_bits(const QuadBits& b) { return b[0] | b[1] | b[2] | b[3]; }
[[gnu::always_inline]] inline std::uint64_t any_bits(const OctetBits& b) {
  return b[0] | b[1] | b[2] | b[3] | b[4] | b[5] | b[6] | b[7];
}
/// How many lanes a comparison holds in, of one or of several added up: each is minus one.
[[gnu::always_inline]] inline std::int64_t count(const QuadInt& c) { return -(c[0] + c[1] + c[2] + c[3]); }
[[gnu::always_inline]] inline std::int64_t count(const OctetInt& c) {
  return -(c[0] + c[1] + c[2] + c[3] + c[4] + c[5] + c[6] + c[7]);
}

/// Rows become columns, in place.
[[gnu::always_inline]] inline void transpose(Quad& a, Quad& b, Quad& c, Quad& d) {
  const Quad ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6);
  const Quad ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Quad cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6);
  const Quad cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  a = __builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5);
  b = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5);
  c = __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7);
  d = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7);
}

/// The columns of four or eight rows of four doubles.
[[gnu::always_inline]] inline void load_rows(const QuadInMemory* const (&row)[4], int at, Quad& a, Quad& b, Quad& c,
                                             Quad& d) {
  a = row[0][at];
  b = row[1][at];
  c = row[2][at];
  d = row[3][at];
  transpose(a, b, c, d);
}
[[gnu::always_inline]] inline Octet join(const Quad& low, const Quad& high) {
  return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
}
[[gnu::always_inline]] inline Quad low_half(const Octet& o) { return __builtin_shufflevector(o, o, 0, 1, 2, 3); }
[[gnu::always_inline]] inline void load_rows(const QuadInMemory* const (&row)[8], int at, Octet& a, Octet& b, Octet& c,
                                             Octet& d) {
  const Octet r02 = join(row[0][at], row[2][at]);
  const Octet r13 = join(row[1][at], row[3][at]);
  const Octet r46 = join(row[4][at], row[6][at]);
  const Octet r57 = join(row[5][at], row[7][at]);
  const Octet ac_low = __builtin_shufflevector(r02, r13, 0, 8, 2, 10, 4, 12, 6, 14);
  const Octet bd_low = __builtin_shufflevector(r02, r13, 1, 9, 3, 11, 5, 13, 7, 15);
  const Octet ac_high = __builtin_shufflevector(r46, r57, 0, 8, 2, 10, 4, 12, 6, 14);
  const Octet bd_high = __builtin_shufflevector(r46, r57, 1, 9, 3, 11, 5, 13, 7, 15);
  a = __builtin_shufflevector(ac_low, ac_high, 0, 1, 4, 5, 8, 9, 12, 13);
  b = __builtin_shufflevector(bd_low, bd_high, 0, 1, 4, 5, 8, 9, 12, 13);
  c = __builtin_shufflevector(ac_low, ac_high, 2, 3, 6, 7, 10, 11, 14, 15);
  d = __builtin_shufflevector(bd_low, bd_high, 2, 3, 6, 7, 10, 11, 14, 15);
}

/// Eight rows become columns, and columns rows, in place.
[[gnu::always_inline]] inline void transpose(Octet (&r)[8]) {
  Octet pairs[8];  // of neighbouring rows: the even columns of the first two, the odd ones, those of the next two ...
  for (int k = 0; k < 8; k += 2) {
    pairs[k] = __builtin_shufflevector(r[k], r[k + 1], 0, 8, 2, 10, 4, 12, 6, 14);
    pairs[k + 1] = __builtin_shufflevector(r[k], r[k + 1], 1, 9, 3, 11, 5, 13, 7, 15);
  }
  for (int k = 0; k < 2; ++k) {
    const Octet low_03 = __builtin_shufflevector(pairs[k], pairs[k + 2], 0, 1, 2, 3, 8, 9, 10, 11);
    const Octet high_03 = __builtin_shufflevector(pairs[k], pairs[k + 2], 4, 5, 6, 7, 12, 13, 14, 15);
    const Octet low_47 = __builtin_shufflevector(pairs[k + 4], pairs[k + 6], 0, 1, 2, 3, 8, 9, 10, 11);
    const Octet high_47 = __builtin_shufflevector(pairs[k + 4], pairs[k + 6], 4, 5, 6, 7, 12, 13, 14, 15);
    r[k] = __builtin_shufflevector(low_03, low_47, 0, 1, 4, 5, 8, 9, 12, 13);
    r[k + 2] = __builtin_shufflevector(low_03, low_47, 2, 3, 6, 7, 10, 11, 14, 15);
    r[k + 4] = __builtin_shufflevector(high_03, high_47, 0, 1, 4, 5, 8, 9, 12, 13);
    r[k + 6] = __builtin_shufflevector(high_03, high_47, 2, 3, 6, 7, 10, 11, 14, 15);
  }
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

/// AVX-512 has an instruction for it.
[[gnu::always_inline]] inline Octet to_double(const OctetInt& value) { return __builtin_convertvector(value, Octet); }

}  // namespace repose
