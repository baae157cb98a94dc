#pragma once

#include <cmath>

#include "contact/hertz.h"

namespace repose {

/// Rolling moment M in N m that resists the first body (-M acts on it, +M on the second): the elastic-plastic spring
/// model without dashpot, "EPSD2" (thesis eqs. 2.18 to 2.22 as corrected; Ai, Chen, Rotter, Ooi 2011, model C,
/// doi:10.1016/j.powtec.2010.09.030). M advances by k_r w dt, k_r = k_t R_eff^2, cut to mu_r |F_n| R_eff.
[[gnu::always_inline]] inline Vec3 epsd2_moment(const PairParameters& pair, const ContactStiffness& k,
                                                const ContactGeometry& contact, double normal_force, double dt,
                                                const Vec3& moment) {
  const double k_r = k.tangential * contact.radius_eff * contact.radius_eff;
  const Vec3 trial = moment + (k_r * dt) * contact.rolling_velocity;
  const double size = norm(trial);
  const double limit = pair.rolling_friction * std::fabs(normal_force) * contact.radius_eff;
  const double remaining = size > limit ? limit / size : 1.0;
  return remaining * trial;
}

}  // namespace repose
