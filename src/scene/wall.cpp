#include "scene/wall.h"

#include <cstdlib>
#include <stdexcept>

#include <fmt/format.h>

#include "base/error.h"

namespace repose {

namespace {

Rectangle make_rectangle(const Vec3& corner, const Vec3& edge_u, const Vec3& edge_v) {
  const Vec3 u = unit_vector(edge_u);
  const Vec3 v = unit_vector(edge_v);
  if (std::fabs(dot(u, v)) > 1e-9) throw std::invalid_argument("the edges of a rectangle must be perpendicular");
  return {corner, u, v, norm(edge_u), norm(edge_v), unit_vector(cross(u, v))};
}

std::variant<Plane, Rectangle, Profile> make_shape(const WallDeck& deck) {
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
  }
  throw std::invalid_argument("unknown shape");
}

}  // namespace

Wall make_wall(const WallDeck& deck, int material) {
  try {
    return {deck.name, material, deck.present, make_shape(deck)};
  } catch (const std::invalid_argument& problem) {
    throw DeckError(fmt::format("wall \"{}\": {}", deck.name, problem.what()));
  }
}

int find_touches(const Wall& wall, int wall_index, const Vec3& centre, double reach, TouchBuffer& out) {
  const int before = out.size();
  std::visit([&](const auto& shape) { find_touches(shape, centre, reach, wall_index, out); }, wall.shape);
  return out.size() - before;
}

double distance(const Wall& wall, const Vec3& centre) {
  return std::visit([&](const auto& shape) { return distance(shape, centre); }, wall.shape);
}

Face face_of(const Wall& wall, int feature) {
  return std::visit([&](const auto& shape) { return face_of(shape, feature); }, wall.shape);
}

double margin(const Wall& wall, int feature, const Vec3& centre) {
  return std::visit([&](const auto& shape) { return margin(shape, feature, centre); }, wall.shape);
}

bool adjacent_features(const Wall& wall, int a, int b) {
  const int apart = std::abs(a - b);
  const auto* profile = std::get_if<Profile>(&wall.shape);
  if (profile == nullptr || !profile->closed) return apart <= 2;
  return apart <= 2 || apart >= 2 * static_cast<int>(profile->vertices.size()) - 2;
}

}  // namespace repose
