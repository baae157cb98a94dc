#include "scene/wall_shapes.h"

#include <algorithm>
#include <stdexcept>

namespace repose {

namespace {

WallTouch face_touch(double signed_distance, const Vec3& face_normal, const Vec3& centre, int wall, int feature) {
  const Vec3 normal = signed_distance < 0.0 ? -face_normal : face_normal;
  const double distance = std::fabs(signed_distance);
  return {
      .distance = distance, .normal = normal, .point = centre - distance * normal, .wall = wall, .feature = feature};
}

struct RectanglePoint {
  Vec3 offset;  // from the nearest point to the centre
  bool on_face;
};

RectanglePoint nearest(const Rectangle& rectangle, const Vec3& centre) {
  const Vec3 d = centre - rectangle.corner;
  const double a = dot(d, rectangle.u);
  const double b = dot(d, rectangle.v);
  const double nearest_a = std::clamp(a, 0.0, rectangle.length_u);
  const double nearest_b = std::clamp(b, 0.0, rectangle.length_v);
  return {d - (nearest_a * rectangle.u + nearest_b * rectangle.v), a == nearest_a && b == nearest_b};
}

}  // namespace

double distance(const Plane& plane, const Vec3& centre) { return std::fabs(dot(centre - plane.point, plane.normal)); }

void find_touches(const Plane& plane, const Vec3& centre, double reach, int wall, TouchBuffer& out) {
  const double signed_distance = dot(centre - plane.point, plane.normal);
  if (std::fabs(signed_distance) < reach) out.add(face_touch(signed_distance, plane.normal, centre, wall, 0));
}

double distance(const Rectangle& rectangle, const Vec3& centre) {
  const RectanglePoint near = nearest(rectangle, centre);
  return near.on_face ? std::fabs(dot(centre - rectangle.corner, rectangle.normal)) : norm(near.offset);
}

void find_touches(const Rectangle& rectangle, const Vec3& centre, double reach, int wall, TouchBuffer& out) {
  const RectanglePoint near = nearest(rectangle, centre);
  if (near.on_face) {
    const double signed_distance = dot(centre - rectangle.corner, rectangle.normal);
    if (std::fabs(signed_distance) < reach) out.add(face_touch(signed_distance, rectangle.normal, centre, wall, 0));
    return;
  }
  const double d = norm(near.offset);
  if (d < reach) {
    out.add({.distance = d,
             .normal = (1.0 / d) * near.offset,
             .point = centre - near.offset,
             .wall = wall,
             .feature = 0,
             .on_face = false});
  }
}

Vec3 unit_vector(const Vec3& v) {
  const double length = norm(v);
  if (!(length > 1e-150 && length < 1e150)) throw std::invalid_argument("a direction must not be of zero length");
  return {v.x / length, v.y / length, v.z / length};
}

}  // namespace repose
