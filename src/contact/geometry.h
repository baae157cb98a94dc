#pragma once

#include "base/vec3.h"
#include "scene/contact_memory.h"

namespace repose {

/// What every contact law sees of a contact, whether between two particles or of a particle with a wall. The normal
/// points from the second body to the first; velocities are those of the first relative to the second.
struct ContactGeometry {
  Vec3 normal;
  double overlap;            ///< m, not negative
  double radius_eff;         ///< R_eff, m (thesis eq. 2.13); R at a wall
  double mass_eff;           ///< m_eff, kg (thesis eq. 2.14); m at a wall
  double normal_velocity;    ///< m/s, positive when parting
  Vec3 tangential_velocity;  ///< m/s, of the surfaces at the contact point
  Vec3 rolling_velocity;     ///< rad/s, relative rotation without its part along the normal
};

/// `v` without its part along the unit vector `n`.
constexpr Vec3 without_normal_part(const Vec3& v, const Vec3& n) { return v - dot(v, n) * n; }

}  // namespace repose
