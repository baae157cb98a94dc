#include "scene/walls/wall_shapes.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace repose {

namespace {

FlatFace flat(const Plane& plane) { return {plane.point, plane.normal}; }
FlatFace flat(const Rectangle& rectangle) { return {rectangle.corner, rectangle.normal}; }

void add_face(const FlatFace& face, const Vec3& centre, double reach, int wall, TouchBuffer& out) {
  const auto [distance, normal] = touch(face, centre);
  if (!(distance < reach)) return;
  out.add({.distance = distance, .normal = normal, .point = centre - distance * normal, .wall = wall, .feature = 0});
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

double distance(const Plane& plane, const Vec3& centre) { return touch(flat(plane), centre).distance; }

void find_touches(const Plane& plane, const Vec3& centre, double reach, int wall, TouchBuffer& out) {
  add_face(flat(plane), centre, reach, wall, out);
}

Face face_of(const Plane& plane, int) { return flat(plane); }

double margin(const Plane&, int, const Vec3&) { return std::numeric_limits<double>::infinity(); }

double distance(const Rectangle& rectangle, const Vec3& centre) {
  const RectanglePoint near = nearest(rectangle, centre);
  return near.on_face ? touch(flat(rectangle), centre).distance : norm(near.offset);
}

void find_touches(const Rectangle& rectangle, const Vec3& centre, double reach, int wall, TouchBuffer& out) {
  const RectanglePoint near = nearest(rectangle, centre);
  if (near.on_face) {
    add_face(flat(rectangle), centre, reach, wall, out);
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

Face face_of(const Rectangle& rectangle, int) { return flat(rectangle); }

double margin(const Rectangle& rectangle, int, const Vec3& centre) {
  const Vec3 d = centre - rectangle.corner;
  const double a = dot(d, rectangle.u);
  const double b = dot(d, rectangle.v);
  return std::min({a, rectangle.length_u - a, b, rectangle.length_v - b});
}

Vec3 unit_vector(const Vec3& v) {
  const double length = norm(v);
  if (!(length > 1e-150 && length < 1e150)) throw std::invalid_argument("a direction must not be of zero length");
  return {v.x / length, v.y / length, v.z / length};
}

}  // namespace repose
