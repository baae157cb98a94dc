#pragma once

#include <type_traits>

#include "contact/geometry.h"
#include "scene/particles/materials.h"

namespace repose {

/// Springs and dashpots of a Hertz-Mindlin contact, all of which scale with sqrt(R_eff delta).
template <class Real>
struct BasicContactStiffness {
  Real normal;              ///< k_n, N/m
  Real tangential;          ///< k_t, N/m
  Real normal_damping;      ///< c_n, kg/s
  Real tangential_damping;  ///< c_t, kg/s
};
using ContactStiffness = BasicContactStiffness<double>;

/// sqrt(R_eff delta) in m: the radius of the circle in which the surfaces meet.
template <class Real>
[[gnu::always_inline]] inline Real contact_radius(const BasicContactGeometry<Real>& contact) {
  return square_root(contact.radius_eff * contact.overlap);
}

/// Thesis eqs. 2.7 to 2.9 as corrected (docs/theory.md): k_n = 4/3 E_eff a, k_t = 8 G_eff a, c = -2 sqrt(5/6) beta
/// sqrt(S m_eff) with S_n = 2 E_eff a and S_t = k_t, where a is the contact radius.
template <class Real>
[[gnu::always_inline]] inline BasicContactStiffness<Real> hertz_stiffness(
    const ContactParameters& pair, const BasicContactGeometry<Real>& contact,
    const std::type_identity_t<Real>& contact_radius) {
  constexpr double four_thirds = 4.0 / 3.0;
  constexpr double minus_two_sqrt_five_sixths = -1.8257418583505538;
  const Real k_n = four_thirds * pair.youngs_modulus_eff * contact_radius;
  const Real k_t = 8.0 * pair.shear_modulus_eff * contact_radius;
  const Real s_n = 2.0 * pair.youngs_modulus_eff * contact_radius;
  const Real c_n = minus_two_sqrt_five_sixths * pair.damping_ratio * square_root(s_n * contact.mass_eff);
  return {k_n, k_t, c_n, c_n * pair.tangential_damping_ratio};
}

/// F_n = k_n delta - c_n v_n in N, positive when repelling (thesis eq. 2.6). It may attract at the end of a rebound.
template <class Real>
[[gnu::always_inline]] inline Real hertz_force(const BasicContactStiffness<Real>& k,
                                               const BasicContactGeometry<Real>& contact) {
  return k.normal * contact.overlap - k.normal_damping * contact.normal_velocity;
}

}  // namespace repose
