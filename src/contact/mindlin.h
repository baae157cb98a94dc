#pragma once

#include <cmath>

#include "contact/hertz.h"

namespace repose {

/// Tangential force on the first body in N, with history and Coulomb's limit (thesis eqs. 2.6, 2.15). The spring
/// advances by v_t dt and loses its normal part; where k_t |xi| exceeds mu |F_n| the force is cut to it, the spring
/// follows and no dashpot acts. `spring` is replaced by its new value.
[[gnu::always_inline]] inline Vec3 mindlin_force(const PairParameters& pair, const ContactStiffness& k,
                                                 const ContactGeometry& contact, double normal_force, double dt,
                                                 Vec3& spring) {
  const Vec3 xi = without_normal_part(spring + dt * contact.tangential_velocity, contact.normal);
  const double trial = k.tangential * norm(xi);
  const double limit = pair.sliding_friction * std::fabs(normal_force);
  const bool slides = trial > limit;
  const double remaining = slides ? limit / trial : 1.0;
  const double damping = slides ? 0.0 : k.tangential_damping;
  spring = remaining * xi;
  return (-k.tangential) * spring - damping * contact.tangential_velocity;
}

}  // namespace repose
