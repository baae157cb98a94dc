#pragma once

#include "contact/hertz.h"
#include "scene/particles/hooke_spring.h"

namespace repose {

/// Hooke's springs with dashpots (Cundall, Strack 1979, doi:10.1680/geot.1979.29.1.47): k_t / k_n is that of the pair,
/// c = -2 beta sqrt(k m_eff), or c = gamma m_eff with the damping rates of the pair (docs/theory.md, O.1). Zero without
/// overlap, as are those of Hertz.
template <class Real>
[[gnu::always_inline]] inline BasicContactStiffness<Real> hooke_stiffness(const PairParameters& pair,
                                                                          const BasicContactGeometry<Real>& contact) {
  const auto touching = contact.overlap > Real{};
  const Real k_n = select(touching, hooke_normal_stiffness(pair, contact.radius_eff, contact.mass_eff), Real{});
  const Real k_t = pair.coefficients.hooke_tangential_ratio * k_n;
  if (has_hooke_damping_rate(pair.coefficients)) {
    const Real mass = select(touching, contact.mass_eff, Real{});
    return {k_n, k_t, pair.coefficients.hooke_damping_rate * mass,
            pair.coefficients.hooke_tangential_damping_rate * mass};
  }
  const Real c_n = -2.0 * pair.damping_ratio * square_root(k_n * contact.mass_eff);
  return {k_n, k_t, c_n, c_n * pair.tangential_damping_ratio};
}

}  // namespace repose
