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

/// Whether what moves `leader` leaves the shape somewhere else.
bool is_moved(const WallShape& shape, const Wall& leader) {
  const auto moves_shape = [&](const MotionDeck& motion) {
    if (motion.type == MotionType::conveyor) return false;
    return std::visit([&](const auto& surface) { return !keeps(surface, motion); }, shape);
  };
  const std::vector<MotionDeck>& motions = leader.motions.motions();
  return leader.servo || std::any_of(motions.begin(), motions.end(), moves_shape);
}

/// Where a wall that moves by itself takes its body.
Placement placement_of(const Wall& leader, double dt) {
  const Placement placement = leader.motions.placement(dt);
  return leader.servo ? carried(leader.servo->placement(), placement) : placement;
}

void put(Wall& wall, const Placement& placement) {
  if (wall.travels) wall.placement = placement;
  wall.placement.motion = placement.motion;
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
    wall.travels = is_moved(wall.shape, wall);
    return wall;
  } catch (const std::invalid_argument& problem) {
    throw DeckError(fmt::format("wall \"{}\": {}", deck.name, problem.what()));
  }
}

void join(std::vector<Wall>& walls, std::size_t follower, std::size_t leader) {
  walls.at(follower).moves_with = leader;
  walls[follower].travels = is_moved(walls[follower].shape, walls.at(leader));
}

std::vector<std::size_t> body_of(std::span<const Wall> walls, std::size_t leader) {
  std::vector<std::size_t> body;
  for (std::size_t w = 0; w < walls.size(); ++w) {
    if (w == leader || walls[w].moves_with == leader) body.push_back(w);
  }
  return body;
}

void place(Wall& wall, double dt) { put(wall, placement_of(wall, dt)); }

void place(std::span<Wall> walls, double dt) {
  for (std::size_t leader = 0; leader < walls.size(); ++leader) {
    if (!walls[leader].moves() || walls[leader].moves_with) continue;
    const Placement placement = placement_of(walls[leader], dt);
    put(walls[leader], placement);
    for (Wall& wall : walls) {
      if (wall.moves_with == leader) put(wall, placement);
    }
  }
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
