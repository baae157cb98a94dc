#pragma once

#include <cmath>

#include "contact/geometry.h"
#include "scene/materials.h"

namespace repose {

/// Springs and dashpots of a Hertz-Mindlin contact, all of which scale with sqrt(R_eff delta).
struct ContactStiffness {
  double normal;              ///< k_n, N/m
  double tangential;          ///< k_t, N/m
  double normal_damping;      ///< c_n, kg/s
  double tangential_damping;  ///< c_t, kg/s
};

/// Thesis eqs. 2.7 to 2.9 as corrected (docs/theory.md): k_n = 4/3 E_eff sqrt(R_eff delta), k_t = 8 G_eff sqrt(R_eff
/// delta), c = -2 sqrt(5/6) beta sqrt(S m_eff) with S_n = 2 E_eff sqrt(R_eff delta) and S_t = k_t.
[[gnu::always_inline]] inline ContactStiffness hertz_stiffness(const PairParameters& pair,
                                                               const ContactGeometry& contact) {
  constexpr double four_thirds = 4.0 / 3.0;
  constexpr double minus_two_sqrt_five_sixths = -1.8257418583505538;
  const double contact_radius = std::sqrt(contact.radius_eff * contact.overlap);
  const double k_n = four_thirds * pair.youngs_modulus_eff * contact_radius;
  const double k_t = 8.0 * pair.shear_modulus_eff * contact_radius;
  const double s_n = 2.0 * pair.youngs_modulus_eff * contact_radius;
  const double c_n = minus_two_sqrt_five_sixths * pair.damping_ratio * std::sqrt(s_n * contact.mass_eff);
  return {k_n, k_t, c_n, c_n * pair.tangential_damping_ratio};
}

/// F_n = k_n delta - c_n v_n in N, positive when repelling (thesis eq. 2.6). It may attract at the end of a rebound.
[[gnu::always_inline]] inline double hertz_force(const ContactStiffness& k, const ContactGeometry& contact) {
  return k.normal * contact.overlap - k.normal_damping * contact.normal_velocity;
}

}  // namespace repose
