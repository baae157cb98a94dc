#pragma once

#include <variant>

#include "base/quad.h"

// A face of a wall as a particle sees it that cannot reach the face's edges. Functions of one centre (Real = double) or
// of four (Real = Quad), which give the same bits.

namespace repose {

template <class Real>
struct BasicFaceTouch {
  Real distance;         ///< m, from the centre to the face
  Vector3<Real> normal;  ///< unit, towards the centre
};

/// Part of a plane.
struct FlatFace {
  Vec3 point;
  Vec3 normal;  ///< unit
};

/// A straight line in the half-plane (r, z) turned around an axis.
struct TurnedFace {
  Vec3 origin;  ///< where z = 0
  Vec3 axis;    ///< unit
  Vec3 aside;   ///< unit, perpendicular to the axis: the meridian of a centre on the axis
  double r;     ///< of a point of the line
  double z;
  double dr;  ///< unit direction (dr, dz)
  double dz;
};

using Face = std::variant<FlatFace, TurnedFace>;

/// A centre in the cylinder coordinates of an axis.
template <class Real>
struct BasicMeridian {
  Real rho;
  Real z;
  Vector3<Real> outward;  ///< unit, away from the axis
};

template <class Real>
[[gnu::always_inline]] inline BasicMeridian<Real> meridian(const Vec3& origin, const Vec3& axis_of_all,
                                                           const Vec3& aside, const Vector3<Real>& centre) {
  const auto axis = broadcast<Real>(axis_of_all);
  const Vector3<Real> d = centre - broadcast<Real>(origin);
  const Real z = dot(d, axis);
  Vector3<Real> across = d - z * axis;
  across -= dot(across, axis) * axis;  // a second pass removes what rounding left along the axis
  const Real rho = square_root(squared_norm(across));
  const auto on_axis = rho < broadcast<Real>(1e-100);  // nearer, the squares lose their digits
  return {rho,
          z,
          {select(on_axis, broadcast<Real>(aside.x), across.x / rho),
           select(on_axis, broadcast<Real>(aside.y), across.y / rho),
           select(on_axis, broadcast<Real>(aside.z), across.z / rho)}};
}

template <class Real>
[[gnu::always_inline]] inline BasicFaceTouch<Real> touch(const FlatFace& face, const Vector3<Real>& centre) {
  const auto normal = broadcast<Real>(face.normal);
  const Real signed_distance = dot(centre - broadcast<Real>(face.point), normal);
  const auto behind = signed_distance < Real{};
  return {
      magnitude(signed_distance),
      {select(behind, -normal.x, normal.x), select(behind, -normal.y, normal.y), select(behind, -normal.z, normal.z)}};
}

template <class Real>
[[gnu::always_inline]] inline BasicFaceTouch<Real> touch(const TurnedFace& face, const Vector3<Real>& centre) {
  const BasicMeridian<Real> at = meridian(face.origin, face.axis, face.aside, centre);
  const auto dr = broadcast<Real>(face.dr);
  const auto dz = broadcast<Real>(face.dz);
  const Real signed_distance = dr * (at.z - broadcast<Real>(face.z)) - dz * (at.rho - broadcast<Real>(face.r));
  const Real side = select(signed_distance < Real{}, broadcast<Real>(-1.0), broadcast<Real>(1.0));
  return {magnitude(signed_distance), (-side * dz) * at.outward + (side * dr) * broadcast<Real>(face.axis)};
}

}  // namespace repose
