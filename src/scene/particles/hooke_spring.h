#pragma once

#include "base/root.h"
#include "scene/particles/materials.h"

namespace repose {

/// k_n in N/m: that of the pair, or, with a characteristic velocity V, the one whose undamped impact at V goes as
/// deep as Hertz's: 16/15 sqrt(R_eff) E_eff (15 m_eff V^2 / (16 sqrt(R_eff) E_eff))^(1/5) (docs/theory.md).
template <class Real>
[[gnu::always_inline]] inline Real hooke_normal_stiffness(const PairParameters& pair, const Real& radius_eff,
                                                          const Real& mass_eff) {
  const double speed = pair.options.hooke_characteristic_velocity;
  if (!(speed > 0.0)) return broadcast<Real>(pair.coefficients.hooke_stiffness);
  const Real stiffness = (16.0 / 15.0 * pair.youngs_modulus_eff) * square_root(radius_eff);
  return stiffness * odd_root<5>(mass_eff * (speed * speed) / stiffness);
}

}  // namespace repose
