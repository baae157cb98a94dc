#pragma once

#include <type_traits>

#include "contact/hertz.h"

namespace repose {

/// Rolling moment M in N m that resists the first body (-M acts on it, +M on the second): the elastic-plastic spring
/// model without dashpot, "EPSD2" (thesis eqs. 2.18 to 2.22 as corrected; Ai, Chen, Rotter, Ooi 2011, model C,
/// doi:10.1016/j.powtec.2010.09.030). M advances by k_r w dt, k_r = k_t R_eff^2, cut to mu_r |F_n| R_eff.
template <class Real>
[[gnu::always_inline]] inline Vector3<Real> epsd2_moment(const PairParameters& pair,
                                                         const BasicContactStiffness<Real>& k,
                                                         const BasicContactGeometry<Real>& contact,
                                                         const std::type_identity_t<Real>& normal_force, double dt,
                                                         const std::type_identity_t<Vector3<Real>>& moment) {
  const Real k_r = k.tangential * contact.radius_eff * contact.radius_eff;
  const Vector3<Real> trial = moment + (k_r * dt) * contact.rolling_velocity;
  const Real size = square_root(squared_norm(trial));
  const Real limit = pair.rolling_friction * magnitude(normal_force) * contact.radius_eff;
  const Real remaining = select(size > limit, limit / size, broadcast<Real>(1.0));
  return remaining * trial;
}

}  // namespace repose
