#pragma once

#include <array>
#include <cstddef>

#include "base/vec3.h"

// Geometry of one triangle and of one segment.

namespace repose {

/// The corners of a triangle.
using Corners = std::array<Vec3, 3>;

/// Twice the area times the unit normal.
inline Vec3 area_vector(const Corners& corners) { return cross(corners[1] - corners[0], corners[2] - corners[0]); }

/// Where along the segment from `a` to `b` its point nearest to `centre` lies: 0 at a, 1 at b, exactly so for the ends.
inline double nearest_along(const Vec3& a, const Vec3& b, const Vec3& centre) {
  const Vec3 ab = b - a;
  const double along = dot(ab, centre - a);
  const double length2 = squared_norm(ab);
  if (!(along > 0.0)) return 0.0;
  return along >= length2 ? 1.0 : along / length2;
}

/// The point of a triangle that is nearest to a centre, and the part it lies on: 0 is the face, 1 + k the edge from
/// corner k to the next, 4 + k the corner k.
struct NearestOnTriangle {
  Vec3 point;
  std::size_t part;
  double squared_distance;
};

/// For a triangle with an area. A centre that does not project onto the face is nearest to one of the edges that it is
/// beyond.
inline NearestOnTriangle nearest_on(const Corners& corners, const Vec3& centre) {
  const Vec3 n = area_vector(corners);
  NearestOnTriangle best{{}, 0, 1e300};
  bool beyond_an_edge = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const Vec3& a = corners[k];
    const Vec3& b = corners[next];
    if (dot(cross(n, b - a), centre - a) >= 0.0) continue;
    beyond_an_edge = true;
    const double along = nearest_along(a, b, centre);
    const Vec3 point = along == 1.0 ? b : a + along * (b - a);
    const double squared_distance = squared_norm(centre - point);
    if (squared_distance >= best.squared_distance) continue;
    best = {point, along == 0.0 ? 4 + k : along == 1.0 ? 4 + next : 1 + k, squared_distance};
  }
  if (beyond_an_edge) return best;
  const double height = dot(centre - corners[0], n) / squared_norm(n);
  return {centre - height * n, 0, height * height * squared_norm(n)};
}

}  // namespace repose
