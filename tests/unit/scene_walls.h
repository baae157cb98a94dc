#pragma once

#include <array>
#include <vector>

#include "scene/walls/wall.h"

/// Walls for the tests, of the material 0.
namespace repose {

inline Wall plane_wall(const Vec3& point, const Vec3& normal) {
  WallDeck deck;
  deck.name = "plane";
  deck.type = WallType::plane;
  deck.point = point;
  deck.normal = normal;
  return make_wall(deck, 0);
}

inline Wall disc_wall(const Vec3& centre, double radius, const Vec3& normal = {0.0, 0.0, 1.0}) {
  WallDeck deck;
  deck.name = "lid";
  deck.type = WallType::disc;
  deck.centre = centre;
  deck.radius = radius;
  deck.normal = normal;
  return make_wall(deck, 0);
}

inline Wall rectangle_wall(const Vec3& corner, const Vec3& edge_u, const Vec3& edge_v) {
  WallDeck deck;
  deck.name = "plate";
  deck.type = WallType::rectangle;
  deck.corner = corner;
  deck.edge_u = edge_u;
  deck.edge_v = edge_v;
  return make_wall(deck, 0);
}

inline Wall profile_wall(const std::vector<std::array<double, 2>>& points, const Vec3& origin = {},
                         const Vec3& axis = {0.0, 0.0, 1.0}) {
  WallDeck deck;
  deck.name = "funnel";
  deck.type = WallType::profile;
  deck.points = points;
  deck.axis_origin = origin;
  deck.axis_direction = axis;
  return make_wall(deck, 0);
}

}  // namespace repose
