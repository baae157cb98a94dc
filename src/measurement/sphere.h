#pragma once

#include "base/math.h"
#include "base/vec3.h"

namespace repose {

/// A grain as the measurements see it: m.
struct Sphere {
  Vec3 centre;
  double radius = 0.0;
};

constexpr double volume(const Sphere& s) { return 4.0 / 3.0 * pi * s.radius * s.radius * s.radius; }

}  // namespace repose
