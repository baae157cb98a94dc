#pragma once

#include <type_traits>

#include "contact/hertz.h"

// Tangential force with history and Coulomb's limit (thesis eqs. 2.6, 2.15): the spring advances by v_t dt and loses
// its normal part; where k_t |xi| exceeds mu |F_n| the force is cut to it, the spring follows and no dashpot acts.

namespace repose {

/// The spring xi in m after `dt` s, before the limit.
template <class Real>
[[gnu::always_inline]] inline Vector3<Real> trial_spring(const BasicContactGeometry<Real>& contact, double dt,
                                                         const std::type_identity_t<Vector3<Real>>& spring) {
  return without_normal_part(spring + broadcast<Real>(dt) * contact.tangential_velocity, contact.normal);
}

/// What Coulomb's limit leaves.
template <class Real>
struct BasicSlidingLimit {
  Real share;    ///< of the trial spring
  Real damping;  ///< kg/s, of the tangential dashpot
};

/// `length` (m) is that of the trial spring.
template <class Real>
[[gnu::always_inline]] inline BasicSlidingLimit<Real> sliding_limit(const ContactParameters& pair,
                                                                    const BasicContactStiffness<Real>& k,
                                                                    const std::type_identity_t<Real>& normal_force,
                                                                    const std::type_identity_t<Real>& length) {
  const Real trial = k.tangential * length;
  const Real limit = pair.sliding_friction * magnitude(normal_force);
  const auto slides = trial > limit;
  return {select(slides, limit / trial, broadcast<Real>(1.0)), select(slides, Real{}, k.tangential_damping)};
}

/// On the first body in N; `spring` and `damping` are those that the limit leaves.
template <class Real>
[[gnu::always_inline]] inline Vector3<Real> mindlin_force(const BasicContactStiffness<Real>& k,
                                                          const BasicContactGeometry<Real>& contact,
                                                          const std::type_identity_t<Vector3<Real>>& spring,
                                                          const std::type_identity_t<Real>& damping) {
  return (-k.tangential) * spring - damping * contact.tangential_velocity;
}

}  // namespace repose
