#pragma once

#include "contact/geometry.h"
#include "scene/particles/materials.h"

namespace repose {

/// N: the pull of a liquid bridge, F_0 = 4 pi gamma R_eff cos(theta) while the surfaces touch, falling linearly with
/// the gap to 0 where it breaks, at s_c = (1 + theta / 2) V^(1/3) (Lian, Thornton, Adams 1993,
/// doi:10.1006/jcis.1993.1452).
template <class Real>
[[gnu::always_inline]] inline Real capillary_pull(const PairParameters& pair,
                                                  const BasicContactGeometry<Real>& contact) {
  const Real stretched = select(contact.overlap < Real{}, contact.overlap, Real{});
  const Real share = 1.0 + stretched * pair.capillary.one_over_breaking_distance;
  return select(contact.overlap != Real{}, pair.capillary.force_per_radius * contact.radius_eff * share, Real{});
}

}  // namespace repose
