#pragma once

#include "contact/epsd2.h"

// The elastic-plastic spring and dashpot model of the rolling moment, "EPSD" (Ai, Chen, Rotter, Ooi 2011, model C,
// doi:10.1016/j.powtec.2010.09.030, with the stiffness that LIGGGHTS 3.8 takes from there). The spring is
// that of epsd2.h with another stiffness; the dashpot acts as long as the spring is not at its limit.

namespace repose {

/// k_r = 2.25 k_n (mu_r R_eff)^2 in N m.
template <class Real>
[[gnu::always_inline]] inline Real epsd_stiffness(const PairParameters& pair, const BasicContactStiffness<Real>& k,
                                                  const BasicContactGeometry<Real>& contact) {
  const Real arm = pair.rolling_friction * contact.radius_eff;
  return 2.25 * k.normal * arm * arm;
}

/// kg m2, from m R^2 of both bodies: 7/5 of what each has by itself, 1/I = 1/I_i + 1/I_j.
template <class Real>
[[gnu::always_inline]] inline Real rolling_inertia(const Real& first, const Real& second) {
  return 1.4 * (first * second / (first + second));
}

/// c_r = 2 eta sqrt(I k_r) in N m s, with the reduced moment of inertia I of both bodies about the contact point.
template <class Real>
[[gnu::always_inline]] inline Real epsd_damping(const PairParameters& pair, const Real& k_r,
                                                const BasicContactGeometry<Real>& contact) {
  return 2.0 * pair.coefficients.rolling_viscous_damping * square_root(contact.rolling_inertia * k_r);
}

}  // namespace repose
