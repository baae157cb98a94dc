#pragma once

#include "contact/hertz.h"

namespace repose {

/// Hooke's springs with dashpots: k_n and k_t / k_n are those of the pair, c = -2 beta sqrt(k m_eff) (Cundall, Strack
/// 1979, doi:10.1680/geot.1979.29.1.47; damping: docs/theory.md). Zero without overlap, as are those of Hertz.
template <class Real>
[[gnu::always_inline]] inline BasicContactStiffness<Real> hooke_stiffness(const PairParameters& pair,
                                                                          const BasicContactGeometry<Real>& contact) {
  const auto touching = contact.overlap > Real{};
  const Real k_n = select(touching, broadcast<Real>(pair.coefficients.hooke_stiffness), Real{});
  const Real k_t = pair.coefficients.hooke_tangential_ratio * k_n;
  const Real c_n = -2.0 * pair.damping_ratio * square_root(k_n * contact.mass_eff);
  return {k_n, k_t, c_n, c_n * pair.tangential_damping_ratio};
}

}  // namespace repose
