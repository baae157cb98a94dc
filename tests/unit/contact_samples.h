#pragma once

#include "support/contact_law.h"
#include "support/draw.h"

namespace repose::test {

/// A contact with round numbers: a contact radius of 2e-5 m, k_n = 80 N/m, k_t = 160 N/m, S_n = 120 N/m.
inline PairParameters round_pair() {
  PairParameters pair;
  pair.youngs_modulus_eff = 3e6;
  pair.shear_modulus_eff = 1e6;
  pair.damping_ratio = -0.5;
  pair.tangential_damping_ratio = std::sqrt(4.0 / 3.0);
  pair.sliding_friction = 0.5;
  pair.rolling_friction = 0.25;
  return pair;
}

inline ContactGeometry round_contact() {
  ContactGeometry contact = {};
  contact.normal = {0.0, 0.0, 1.0};
  contact.overlap = 1e-6;
  contact.radius_eff = 4e-4;
  contact.mass_eff = 1.2e-6;
  return contact;
}

inline ContactGeometry random_contact(Draw& draw) {
  ContactGeometry contact = {};
  contact.normal = draw.direction();
  contact.overlap = draw(1e-8, 1e-5);
  contact.radius_eff = draw(1e-4, 1e-3);
  contact.mass_eff = draw(1e-8, 1e-6);
  contact.normal_velocity = draw(-0.1, 0.1);
  contact.tangential_velocity = without_normal_part(draw.vector(0.1), contact.normal);
  contact.rolling_velocity = without_normal_part(draw.vector(100.0), contact.normal);
  return contact;
}

}  // namespace repose::test
