#include "scene/walls/wall.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/core.h>

#include "base/error.h"

namespace repose {

namespace {

/// The first of the shapes that is of the deck's type.
template <class... Shapes>
WallShape made(const WallDeck& deck, const ReadFile& read_file, const std::variant<Shapes...>*) {
  std::optional<WallShape> shape;
  const auto try_shape = [&]<class Shape>() {
    if (!shape && Shape::is(deck.type)) shape.emplace(Shape::made(deck, read_file));
  };
  (try_shape.template operator()<Shapes>(), ...);
  if (!shape) throw std::invalid_argument("unknown shape");
  return std::move(*shape);
}

bool is_moved(const Wall& wall) {
  const auto moves_shape = [&](const MotionDeck& motion) {
    if (motion.type == MotionType::conveyor) return false;
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
    wall.shape = made(deck, read_file, static_cast<const WallShape*>(nullptr));
    wall.motions = Motions(deck.motions);
    if (deck.servo.enabled) wall.servo.emplace(deck.servo);
    wall.travels = is_moved(wall) || wall.servo;
    return wall;
  } catch (const std::invalid_argument& problem) {
    throw DeckError(fmt::format("wall \"{}\": {}", deck.name, problem.what()));
  }
}

void place(Wall& wall, double dt) {
  Placement placement = wall.motions.placement(dt);
  if (wall.servo) placement = carried(wall.servo->placement(), placement);
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
  return std::visit([&](const auto& shape) { return is_within(shape, seen_by(wall, centre), reach); }, wall.shape);
}

Face face_of(const Wall& wall, int feature) {
  return std::visit([&](const auto& shape) { return face_of(shape, feature); }, wall.shape);
}

bool keeps_to_face(const Wall& wall, int feature, const Vec3& centre, double reach, double skin) {
  const Vec3 seen = seen_by(wall, centre);
  return std::visit([&](const auto& shape) { return keeps_to_face(shape, feature, seen, reach, skin); }, wall.shape);
}

bool adjacent_features(const Wall& wall, int a, int b) {
  return std::visit([&](const auto& shape) { return adjacent_features(shape, a, b); }, wall.shape);
}

}  // namespace repose
