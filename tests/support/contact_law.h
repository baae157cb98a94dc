#pragma once

#include "contact/epsd2.h"
#include "contact/hertz.h"
#include "contact/mindlin.h"
#include "scene/contact_memory.h"

// The contact law for one contact, in the order in which docs/theory.md tells it.

namespace repose::test {

inline ContactStiffness hertz_stiffness(const PairParameters& pair, const ContactGeometry& contact) {
  return repose::hertz_stiffness(pair, contact, contact_radius(contact));
}

/// On the first body in N; `spring` is replaced by its new value.
inline Vec3 mindlin_force(const PairParameters& pair, const ContactStiffness& k, const ContactGeometry& contact,
                          double normal_force, double dt, Vec3& spring) {
  const Vec3 trial = trial_spring(contact, dt, spring);
  const BasicSlidingLimit<double> limit = sliding_limit(pair, k, normal_force, norm(trial));
  spring = limit.share * trial;
  return repose::mindlin_force(k, contact, spring, limit.damping);
}

/// The new value of `moment`.
inline Vec3 epsd2_moment(const PairParameters& pair, const ContactStiffness& k, const ContactGeometry& contact,
                         double normal_force, double dt, const Vec3& moment) {
  const Vec3 trial = trial_moment(k, contact, dt, moment);
  return rolling_limit(pair, contact, normal_force, norm(trial)) * trial;
}

struct ContactForces {
  Vec3 force;           ///< N, on the first body
  Vec3 friction_arm;    ///< N, n x F_t: the friction's torque on either body over minus its lever arm
  Vec3 rolling_moment;  ///< N m, taken from the first body and given to the second
};

/// `history` advances by `dt` (0 leaves it as it is).
inline ContactForces contact_law(const PairParameters& pair, const ContactGeometry& contact, double dt,
                                 ContactHistory& history) {
  const ContactStiffness k = hertz_stiffness(pair, contact);
  const double f_n = hertz_force(k, contact);
  const Vec3 f_t = mindlin_force(pair, k, contact, f_n, dt, history.spring);
  history.rolling = epsd2_moment(pair, k, contact, f_n, dt, history.rolling);
  return {f_n * contact.normal + f_t, cross(contact.normal, f_t), history.rolling};
}

}  // namespace repose::test
