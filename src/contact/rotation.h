#pragma once

#include "contact/geometry.h"

namespace repose {

/// `v`, which lay in the tangent plane of an earlier normal, turned into that of the unit vector `n`: its projection,
/// stretched to its old length (Luding 2008, doi:10.1007/s10035-008-0099-x). Zero when it is along n.
template <class Real>
[[gnu::always_inline]] inline Vector3<Real> rotated_into_plane(const Vector3<Real>& v, const Vector3<Real>& n) {
  const Vector3<Real> projected = without_normal_part(v, n);
  const Real remaining = squared_norm(projected);
  const Real stretch = square_root(squared_norm(v) / remaining);
  return select(remaining > Real{}, stretch, Real{}) * projected;
}

}  // namespace repose
