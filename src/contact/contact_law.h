#pragma once

#include "contact/epsd2.h"
#include "contact/hertz.h"
#include "contact/mindlin.h"

namespace repose {

struct ContactForces {
  Vec3 force;           ///< N, on the first body
  Vec3 friction_arm;    ///< N, n x F_t: times minus the lever arm it is the torque of the friction on either body
  Vec3 rolling_moment;  ///< N m, taken from the first body and given to the second
};

/// The contact law of the thesis: Hertz normal, Mindlin tangential, EPSD2 rolling. `history` advances by `dt` (0 leaves
/// it as it is). No branches, so that the pair loop vectorises over it; call it with overlap > 0, or discard the
/// result.
[[gnu::always_inline]] inline ContactForces contact_law(const PairParameters& pair, const ContactGeometry& contact,
                                                        double dt, ContactHistory& history) {
  const ContactStiffness k = hertz_stiffness(pair, contact);
  const double f_n = hertz_force(k, contact);
  const Vec3 f_t = mindlin_force(pair, k, contact, f_n, dt, history.spring);
  history.rolling = epsd2_moment(pair, k, contact, f_n, dt, history.rolling);
  return {f_n * contact.normal + f_t, cross(contact.normal, f_t), history.rolling};
}

}  // namespace repose
