#pragma once

#include <cstdint>

#include "base/philox.h"
#include "base/vec3.h"

namespace repose {

/// The k-th random number in [low, high) of sample i.
inline double draw(std::uint64_t i, std::uint32_t k, double low, double high) {
  return low + (high - low) * uniform(1234, i, RandomStream::insertion_jitter, k);
}

/// A random point in the cube [-half, half)^3; takes the numbers k, k+1, k+2 of sample i.
inline Vec3 draw_point(std::uint64_t i, std::uint32_t k, double half) {
  return {draw(i, k, -half, half), draw(i, k + 1, -half, half), draw(i, k + 2, -half, half)};
}

}  // namespace repose
