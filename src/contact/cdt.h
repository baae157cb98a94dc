#pragma once

#include "contact/hertz.h"

namespace repose {

/// Rolling moment of constant size, "CDT", in N m, taken from the first body: mu_r R_eff times the spring's part of the
/// normal force, k_n delta, along the relative rotation w; then the part along the normal is left out (Ai, Chen,
/// Rotter, Ooi 2011, model A, doi:10.1016/j.powtec.2010.09.030, as in LIGGGHTS 3.8). Without memory.
template <class Real>
[[gnu::always_inline]] inline Vector3<Real> cdt_moment(const PairParameters& pair, const BasicContactStiffness<Real>& k,
                                                       const BasicContactGeometry<Real>& contact) {
  const Real spin = square_root(squared_norm(contact.rolling_velocity) + contact.twist * contact.twist);
  const Real size = pair.rolling_friction * contact.radius_eff * magnitude(k.normal * contact.overlap);
  return select(spin > Real{}, size / spin, Real{}) * contact.rolling_velocity;
}

}  // namespace repose
