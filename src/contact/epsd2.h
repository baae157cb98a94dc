#pragma once

#include <type_traits>

#include "contact/hertz.h"

// Rolling moment M in N m that resists the first body (-M acts on it, +M on the second): the elastic-plastic spring
// model without dashpot, "EPSD2" (thesis eqs. 2.18 to 2.22 as corrected; Ai, Chen, Rotter, Ooi 2011, model C,
// doi:10.1016/j.powtec.2010.09.030). M advances by k_r w dt, k_r = k_t R_eff^2, cut to mu_r |F_n| R_eff.

namespace repose {

/// k_r in N m.
template <class Real>
[[gnu::always_inline]] inline Real epsd2_stiffness(const BasicContactStiffness<Real>& k,
                                                   const BasicContactGeometry<Real>& contact) {
  return k.tangential * contact.radius_eff * contact.radius_eff;
}

/// M after `dt` s, before the limit.
template <class Real>
[[gnu::always_inline]] inline Vector3<Real> trial_moment(const std::type_identity_t<Real>& k_r,
                                                         const BasicContactGeometry<Real>& contact, double dt,
                                                         const std::type_identity_t<Vector3<Real>>& moment) {
  return moment + (k_r * dt) * contact.rolling_velocity;
}

/// The share of the trial moment that the limit leaves; `size` (N m) is its length.
template <class Real>
[[gnu::always_inline]] inline Real rolling_limit(const ContactParameters& pair,
                                                 const BasicContactGeometry<Real>& contact,
                                                 const std::type_identity_t<Real>& normal_force,
                                                 const std::type_identity_t<Real>& size) {
  const Real limit = pair.rolling_friction * magnitude(normal_force) * contact.radius_eff;
  return select(size > limit, limit / size, broadcast<Real>(1.0));
}

}  // namespace repose
