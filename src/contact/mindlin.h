#pragma once

#include <type_traits>

#include "contact/hertz.h"

namespace repose {

/// Tangential force on the first body in N, with history and Coulomb's limit (thesis eqs. 2.6, 2.15). The spring
/// advances by v_t dt and loses its normal part; where k_t |xi| exceeds mu |F_n| the force is cut to it, the spring
/// follows and no dashpot acts. `spring` is replaced by its new value.
template <class Real>
[[gnu::always_inline]] inline Vector3<Real> mindlin_force(const PairParameters& pair,
                                                          const BasicContactStiffness<Real>& k,
                                                          const BasicContactGeometry<Real>& contact,
                                                          const std::type_identity_t<Real>& normal_force, double dt,
                                                          Vector3<Real>& spring) {
  const Vector3<Real> xi =
      without_normal_part(spring + broadcast<Real>(dt) * contact.tangential_velocity, contact.normal);
  const Real trial = k.tangential * square_root(squared_norm(xi));
  const Real limit = pair.sliding_friction * magnitude(normal_force);
  const auto slides = trial > limit;
  const Real remaining = select(slides, limit / trial, broadcast<Real>(1.0));
  const Real damping = select(slides, Real{}, k.tangential_damping);
  spring = remaining * xi;
  return (-k.tangential) * spring - damping * contact.tangential_velocity;
}

}  // namespace repose
