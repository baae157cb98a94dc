#pragma once

#include "base/vec3.h"
#include "scene/particles/contact_memory.h"

namespace repose {

/// What every contact law sees of a contact, whether between two particles or of a particle with a wall. The normal
/// points from the second body to the first; velocities are those of the first relative to the second.
/// Like all of the contact law for one contact (Real = double) or for one in each of four lanes (Real = Quad).
template <class Real>
struct BasicContactGeometry {
  Vector3<Real> normal;
  Real overlap;                       ///< m; negative in an adhesive contact that is pulled, 0: none
  Real radius_eff;                    ///< R_eff, m (thesis eq. 2.13); R at a wall
  Real mass_eff;                      ///< m_eff, kg (thesis eq. 2.14); m at a wall
  Real normal_velocity;               ///< m/s, positive when parting
  Vector3<Real> tangential_velocity;  ///< m/s, of the surfaces at the contact point
  Vector3<Real> rolling_velocity;     ///< rad/s, relative rotation without its part along the normal
  // Only GeneralLaw reads these.
  Vector3<Real> velocity_normal;  ///< the normal that the velocities refer to
  Real twist;                     ///< rad/s, the relative rotation's part along the normal
  Real rolling_inertia;           ///< kg m2, reduced, of both bodies about the contact point
  Real cohesive_area;             ///< m2 (sjkr.h); without cohesion 0
};
using ContactGeometry = BasicContactGeometry<double>;

/// `v` without its part along the unit vector `n`.
template <class Real>
[[gnu::always_inline]] constexpr Vector3<Real> without_normal_part(const Vector3<Real>& v, const Vector3<Real>& n) {
  return v - dot(v, n) * n;
}

}  // namespace repose
