#pragma once

#include "base/math.h"

namespace repose {

/// Mass of a solid sphere in kg from its radius in m (a double, or a Quad of them) and its density in kg/m^3.
template <class Real>
[[gnu::always_inline]] constexpr Real sphere_mass(const Real& radius, double density) {
  return density * (4.0 / 3.0 * pi) * (radius * radius * radius);
}

/// Volume of a sphere in m^3.
constexpr double sphere_volume(double radius) { return sphere_mass(radius, 1.0); }

/// Moment of inertia of a solid sphere about its centre in kg m^2.
constexpr double sphere_inertia(double mass, double radius) { return 0.4 * mass * (radius * radius); }

}  // namespace repose
