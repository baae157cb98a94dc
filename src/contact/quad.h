#pragma once

#include <cstdint>
#include <cstring>

namespace repose {

/// Four doubles as one vector value; the compiler maps it to the registers of the instruction set at hand.
using Quad = double __attribute__((vector_size(32)));
using QuadInt = std::int64_t __attribute__((vector_size(32)));
using QuadBits = std::uint64_t __attribute__((vector_size(32)));

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

}  // namespace repose
