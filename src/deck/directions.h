#pragma once

#include <algorithm>
#include <cmath>

#include "base/vec3.h"

namespace repose {

/// Whether two directions of any length are one, or opposite, up to the rounding of their digits. True when one of them
/// has no length.
inline bool are_parallel(const Vec3& a, const Vec3& b) {
  const auto to_size_one = [](const Vec3& v) {  // so that no square is out of range
    const double size = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
    return size > 0.0 ? Vec3{v.x / size, v.y / size, v.z / size} : Vec3{};
  };
  const Vec3 c = to_size_one(a);
  const Vec3 d = to_size_one(b);
  return norm(cross(c, d)) <= 1e-12 * norm(c) * norm(d);
}

}  // namespace repose
