#pragma once

#include "contact/epsd2.h"
#include "contact/hertz.h"
#include "contact/mindlin.h"

namespace repose {

template <class Real>
struct BasicContactForces {
  Vector3<Real> force;           ///< N, on the first body
  Vector3<Real> friction_arm;    ///< N, n x F_t: the friction's torque on either body over minus its lever arm
  Vector3<Real> rolling_moment;  ///< N m, taken from the first body and given to the second
};
using ContactForces = BasicContactForces<double>;

/// The contact law of the thesis: Hertz normal, Mindlin tangential, EPSD2 rolling. `history` advances by `dt` (0 leaves
/// it as it is). No branches, so that the pair loop vectorises over it; call it with overlap > 0, or discard the
/// result.
template <class Real>
[[gnu::always_inline]] inline BasicContactForces<Real> contact_law(const PairParameters& pair,
                                                                   const BasicContactGeometry<Real>& contact, double dt,
                                                                   BasicContactHistory<Real>& history) {
  const BasicContactStiffness<Real> k = hertz_stiffness(pair, contact);
  const Real f_n = hertz_force(k, contact);
  const Vector3<Real> f_t = mindlin_force(pair, k, contact, f_n, dt, history.spring);
  history.rolling = epsd2_moment(pair, k, contact, f_n, dt, history.rolling);
  return {f_n * contact.normal + f_t, cross(contact.normal, f_t), history.rolling};
}

}  // namespace repose
