#pragma once

#include "contact/contact_law.h"
#include "scene/particles/contact_memory.h"

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
  const Vec3 trial = trial_moment(epsd2_stiffness(k, contact), contact, dt, moment);
  return rolling_limit(pair, contact, normal_force, norm(trial)) * trial;
}

struct ContactForces {
  Vec3 force;           ///< N, on the first body
  Vec3 friction_arm;    ///< N, n x F_t: the friction's torque on either body over minus its lever arm
  Vec3 rolling_moment;  ///< N m, taken from the first body and given to the second
};

/// `history` advances by `dt` (0 leaves it as it is).
template <class Law>
ContactForces contact_law_of(const PairParameters& pair, const ContactGeometry& contact, double dt,
                             ContactHistory& history) {
  const double radius = Law::contact_radius(pair, contact);
  const ContactStiffness k = Law::stiffness(pair, contact, radius);
  const double f_n = Law::normal_force(pair, k, contact, radius);
  const double pressing = Law::pressing_force(pair, k, contact, f_n);
  const Vec3 spring = Law::spring(pair, contact, dt, history.spring);
  const Vec3 moment = Law::moment(pair, k, contact, dt, history.rolling);
  const BasicSlidingLimit<double> limit = Law::sliding(pair, k, contact, pressing, norm(spring));
  const double rolling_share = rolling_limit(pair, contact, pressing, norm(moment));
  const Vec3 limited = limit.share * spring;
  history.spring = Law::remembered(pair, contact, limited);
  history.rolling = rolling_share * moment;
  const Vec3 f_t = Law::friction(pair, k, contact, limited, limit.damping);
  return {Law::with_cohesion(pair, contact, f_n) * contact.normal + f_t, cross(contact.normal, f_t),
          Law::acting_moment(pair, k, contact, history.rolling, rolling_share)};
}

/// The law that the loops choose for the pair.
inline ContactForces contact_law(const PairParameters& pair, const ContactGeometry& contact, double dt,
                                 ContactHistory& history) {
  return with_law(pair, [&](auto law) { return contact_law_of<decltype(law)>(pair, contact, dt, history); });
}

}  // namespace repose::test
