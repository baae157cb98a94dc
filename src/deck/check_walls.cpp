#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "deck/check_deck.h"
#include "deck/nearest.h"

namespace repose {
namespace {

void check_profile(const std::string& section, const WallDeck& wall, DeckErrors& errors) {
  check_direction(section, "axis_direction", wall.axis_direction, errors);
  const std::string key = section + ".points";
  if (wall.points.size() < 2) {
    errors.add(key, fmt::format("\"points\" needs at least 2 points [r, z], not {}", wall.points.size()));
  }
  for (std::size_t i = 0; i < wall.points.size(); ++i) {
    const std::string point = fmt::format("{}.{}", key, i);
    const auto& [r, z] = wall.points[i];
    if (r < 0.0) errors.add(point, fmt::format("r = {} is negative; r is the distance from the axis", r));
    if (i == 0) continue;
    const auto& [r_before, z_before] = wall.points[i - 1];
    if (r == r_before && z == z_before) {
      errors.add(point, "this point repeats the one before; a segment needs a length");
    } else if (r == 0.0 && r_before == 0.0) {
      errors.add(point, "this segment lies on the axis and has no surface; remove one of its points");
    }
  }
}

void check_rectangle(const std::string& section, const WallDeck& wall, DeckErrors& errors) {
  const double u = norm(wall.edge_u);
  const double v = norm(wall.edge_v);
  check_direction(section, "edge_u", wall.edge_u, errors);
  check_direction(section, "edge_v", wall.edge_v, errors);
  // Edges that were typed in decimal are perpendicular only up to rounding.
  if (std::fabs(dot(wall.edge_u, wall.edge_v)) > 1e-9 * u * v) {
    errors.add(section + ".edge_v", "\"edge_v\" is not perpendicular to \"edge_u\"");
  }
}

}  // namespace

void check_direction(const std::string& section, const char* key, const Vec3& direction, DeckErrors& errors) {
  if (norm(direction) > 0.0) return;
  errors.add(section + "." + key, fmt::format("\"{}\" has length zero; it needs a direction", key));
}

const WallDeck* find_wall(const std::string& key, const std::string& name, const Deck& deck, DeckErrors& errors) {
  std::vector<std::string> names;
  for (const WallDeck& wall : deck.walls) {
    if (wall.name == name) return &wall;
    names.push_back(wall.name);
  }
  const std::string hint =
      names.empty() ? "the deck has none" : fmt::format("the nearest is \"{}\"", nearest(name, names));
  errors.add(key, fmt::format("unknown wall \"{}\"; {}", name, hint));
  return nullptr;
}

std::vector<const WallDeck*> find_walls(const std::string& key, const std::vector<std::string>& names,
                                        const std::string& whom, const Deck& deck, DeckErrors& errors) {
  if (names.empty()) errors.add(key, fmt::format("\"walls\" names none; name those of {}", whom));
  std::vector<const WallDeck*> found;
  for (std::size_t k = 0; k < names.size(); ++k) {
    found.push_back(find_wall(fmt::format("{}.{}", key, k), names[k], deck, errors));
  }
  return found;
}

void check_wall_shapes(const Deck& deck, DeckErrors& errors) {
  for (std::size_t i = 0; i < deck.walls.size(); ++i) {
    const std::string section = fmt::format("wall.{}", i);
    const WallDeck& wall = deck.walls[i];
    if (wall.type == WallType::profile) check_profile(section, wall, errors);
    if (wall.type == WallType::rectangle) check_rectangle(section, wall, errors);
    if (wall.type == WallType::mesh) check_direction(section, "rotate_axis", wall.rotate_axis, errors);
    if (wall.type == WallType::plane || wall.type == WallType::disc) {
      check_direction(section, "normal", wall.normal, errors);
    }
  }
}

}  // namespace repose
