#include "scene/walls/rectangle.h"

#include <algorithm>
#include <stdexcept>

#include "scene/walls/plane.h"
#include "scene/walls/unit_vector.h"

namespace repose {
namespace {

FlatFace flat(const Rectangle& rectangle) { return {rectangle.corner, rectangle.normal}; }

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

Rectangle Rectangle::made(const WallDeck& deck, const ReadFile&) {
  const Vec3 u = unit_vector(deck.edge_u);
  const Vec3 v = unit_vector(deck.edge_v);
  if (std::fabs(dot(u, v)) > 1e-9) throw std::invalid_argument("the edges of a rectangle must be perpendicular");
  return {deck.corner, u, v, norm(deck.edge_u), norm(deck.edge_v), unit_vector(cross(u, v))};
}

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

}  // namespace repose
