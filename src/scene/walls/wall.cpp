#include "scene/walls/wall.h"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

#include <fmt/format.h>

#include "base/error.h"
#include "scene/walls/stl.h"

namespace repose {

namespace {

Rectangle make_rectangle(const Vec3& corner, const Vec3& edge_u, const Vec3& edge_v) {
  const Vec3 u = unit_vector(edge_u);
  const Vec3 v = unit_vector(edge_v);
  if (std::fabs(dot(u, v)) > 1e-9) throw std::invalid_argument("the edges of a rectangle must be perpendicular");
  return {corner, u, v, norm(edge_u), norm(edge_v), unit_vector(cross(u, v))};
}

Mesh read_mesh(const WallDeck& deck, const ReadFile& read_file) {
  const MeshPlacement placement = {deck.scale, deck.rotate_axis, deck.rotate_angle, deck.translate};
  return make_mesh(parse_stl(read_file(deck.file), deck.file), placement, deck.feature_angle);
}

decltype(Wall::shape) make_shape(const WallDeck& deck, const ReadFile& read_file) {
  switch (deck.type) {
    case WallType::plane:
      return Plane{deck.point, unit_vector(deck.normal)};
    case WallType::rectangle:
      return make_rectangle(deck.corner, deck.edge_u, deck.edge_v);
    case WallType::disc:
      if (!(deck.radius > 0.0)) throw std::invalid_argument("the radius of a disc must be positive");
      return make_profile({{0.0, 0.0}, {deck.radius, 0.0}}, deck.centre, deck.normal);
    case WallType::profile:
      return make_profile(deck.points, deck.axis_origin, deck.axis_direction);
    case WallType::mesh:
      return read_mesh(deck, read_file);
  }
  throw std::invalid_argument("unknown shape");
}

// Whether a motion brings every point of the shape to another of its points.
bool keeps(const Plane& plane, const MotionDeck& motion) {
  switch (motion.type) {
    case MotionType::translation:
      return dot(motion.velocity, plane.normal) == 0.0;
    case MotionType::oscillation:
      return dot(motion.amplitude, plane.normal) == 0.0;
    case MotionType::rotation:
      return cross(motion.axis_direction, plane.normal) == Vec3{};
  }
  return false;
}
bool keeps(const Rectangle&, const MotionDeck&) { return false; }
bool keeps(const Mesh&, const MotionDeck&) { return false; }
bool keeps(const Profile& profile, const MotionDeck& motion) {
  return motion.type == MotionType::rotation && cross(motion.axis_direction, profile.axis) == Vec3{} &&
         cross(motion.axis_origin - profile.origin, profile.axis) == Vec3{};
}

bool is_moved(const Wall& wall) {
  const auto moves_shape = [&](const MotionDeck& motion) {
    return std::visit([&](const auto& shape) { return !keeps(shape, motion); }, wall.shape);
  };
  return std::any_of(wall.motions.motions().begin(), wall.motions.motions().end(), moves_shape);
}

Vec3 seen_by(const Wall& wall, const Vec3& centre) { return wall.travels ? wall.placement.back(centre) : centre; }

}  // namespace

Wall make_wall(const WallDeck& deck, int material, const ReadFile& read_file) {
  try {
    Wall wall;
    wall.name = deck.name;
    wall.material = material;
    wall.present = deck.present;
    wall.shape = make_shape(deck, read_file);
    wall.motions = Motions(deck.motions);
    wall.travels = is_moved(wall);
    return wall;
  } catch (const std::invalid_argument& problem) {
    throw DeckError(fmt::format("wall \"{}\": {}", deck.name, problem.what()));
  }
}

void place(Wall& wall, double dt) {
  const Placement placement = wall.motions.placement(dt);
  if (wall.travels) wall.placement = placement;
  wall.placement.motion = placement.motion;
}

int find_touches(const Wall& wall, int wall_index, const Vec3& centre, double reach, TouchBuffer& out) {
  const int before = out.size();
  const Vec3 seen = seen_by(wall, centre);
  std::visit([&](const auto& shape) { find_touches(shape, seen, reach, wall_index, out); }, wall.shape);
  for (int t = before; t < out.size() && wall.travels; ++t) {
    out[t].normal = wall.placement.turn(out[t].normal);
    out[t].point = wall.placement.place(out[t].point);
  }
  return out.size() - before;
}

double distance(const Wall& wall, const Vec3& centre) {
  return std::visit([&](const auto& shape) { return distance(shape, seen_by(wall, centre)); }, wall.shape);
}

bool is_within(const Wall& wall, const Vec3& centre, double reach) {
  if (const auto* mesh = std::get_if<Mesh>(&wall.shape)) return is_within(*mesh, seen_by(wall, centre), reach);
  return distance(wall, centre) < reach;
}

Face face_of(const Wall& wall, int feature) {
  return std::visit([&](const auto& shape) { return face_of(shape, feature); }, wall.shape);
}

namespace {

/// The touches of the other shapes are all their features within reach, so only the end of the face can come nearer.
template <class Shape>
bool keeps_to_face(const Shape& shape, int feature, const Vec3& centre, double, double skin) {
  return margin(shape, feature, centre) > 1.001 * skin;
}

}  // namespace

bool keeps_to_face(const Wall& wall, int feature, const Vec3& centre, double reach, double skin) {
  const Vec3 seen = seen_by(wall, centre);
  return std::visit([&](const auto& shape) { return keeps_to_face(shape, feature, seen, reach, skin); }, wall.shape);
}

bool adjacent_features(const Wall& wall, int a, int b) {
  if (const auto* mesh = std::get_if<Mesh>(&wall.shape)) return adjacent_features(*mesh, a, b);
  const int apart = std::abs(a - b);
  const auto* profile = std::get_if<Profile>(&wall.shape);
  if (profile == nullptr || !profile->closed) return apart <= 2;
  return apart <= 2 || apart >= 2 * static_cast<int>(profile->vertices.size()) - 2;
}

}  // namespace repose
