#include "scene/walls/plane.h"

#include <limits>

#include "scene/walls/unit_vector.h"

namespace repose {
namespace {

FlatFace flat(const Plane& plane) { return {plane.point, plane.normal}; }

}  // namespace

Plane Plane::made(const WallDeck& deck, const ReadFile&) { return {deck.point, unit_vector(deck.normal)}; }

void add_face(const FlatFace& face, const Vec3& centre, double reach, int wall, TouchBuffer& out) {
  const auto [distance, normal] = touch(face, centre);
  if (!(distance < reach)) return;
  out.add({.distance = distance, .normal = normal, .point = centre - distance * normal, .wall = wall, .feature = 0});
}

double distance(const Plane& plane, const Vec3& centre) { return touch(flat(plane), centre).distance; }

void find_touches(const Plane& plane, const Vec3& centre, double reach, int wall, TouchBuffer& out) {
  add_face(flat(plane), centre, reach, wall, out);
}

Face face_of(const Plane& plane, int) { return flat(plane); }

double margin(const Plane&, int, const Vec3&) { return std::numeric_limits<double>::infinity(); }

bool keeps(const Plane& plane, const MotionDeck& motion) {
  switch (motion.type) {
    case MotionType::translation:
      return dot(motion.velocity, plane.normal) == 0.0;
    case MotionType::oscillation:
      return dot(motion.amplitude, plane.normal) == 0.0;
    case MotionType::rotation:
      return cross(motion.axis_direction, plane.normal) == Vec3{};
    case MotionType::conveyor:
      return true;
  }
  return false;
}
}  // namespace repose
