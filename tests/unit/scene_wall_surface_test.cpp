// Walls as polygons to look at: on the wall itself, of its area, where its motions have brought it.
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "base/math.h"
#include "scene/walls/wall_surface.h"
#include "scene_walls.h"
#include "support/meshes.h"

namespace repose {
namespace {

const DomainDeck domain = {{-1.0, -1.0, -1.0}, {1.0, 1.0, 3.0}};

double area(const WallSurface& surface) {
  double sum = 0.0;
  for (const auto& polygon : surface.polygons) {
    Vec3 twice;
    for (std::size_t k = 2; k < polygon.size(); ++k) {
      const Vec3& a = surface.points[polygon[0]];
      twice += cross(surface.points[polygon[k - 1]] - a, surface.points[polygon[k]] - a);
    }
    sum += 0.5 * norm(twice);
  }
  return sum;
}

void expect_on_wall(const WallSurface& surface, const Wall& wall) {
  EXPECT_FALSE(surface.polygons.empty());
  std::set<std::size_t> used;
  for (const auto& polygon : surface.polygons) {
    EXPECT_GE(polygon.size(), 3U);
    EXPECT_EQ(std::set<std::size_t>(polygon.begin(), polygon.end()).size(), polygon.size());
    used.insert(polygon.begin(), polygon.end());
  }
  EXPECT_EQ(used.size(), surface.points.size());
  EXPECT_EQ(*used.rbegin() + 1, surface.points.size());
  for (const Vec3& point : surface.points) EXPECT_LT(distance(wall, point), 1e-14);
}

/// Of a circle with 72 sides over that of a round one.
const double polygon_share = 72.0 / (2.0 * pi) * std::sin(2.0 * pi / 72.0);

TEST(WallSurface, APlaneIsCutAtTheDomain) {
  const Wall flat = plane_wall({5.0, 7.0, 0.5}, {0.0, 0.0, -2.0});
  expect_on_wall(surface_of(flat, domain), flat);
  EXPECT_NEAR(area(surface_of(flat, domain)), 4.0, 1e-14);
  const Wall slope = plane_wall({0.0, 0.0, 1.0}, {0.0, -1.0, 1.0});
  expect_on_wall(surface_of(slope, domain), slope);
  EXPECT_NEAR(area(surface_of(slope, domain)), 4.0 * std::sqrt(2.0), 1e-14);
  const Wall corner = plane_wall({-1.0, -1.0, -0.5}, {1.0, 1.0, 1.0});  // a triangle with edges of 0.5 sqrt(2)
  EXPECT_NEAR(area(surface_of(corner, domain)), 0.5 * std::sqrt(0.75) * 0.5, 1e-14);
  for (const Vec3& point : surface_of(corner, domain).points) {
    EXPECT_GE(point.x, -1.0);
    EXPECT_LE(point.z, 3.0);
  }
  EXPECT_TRUE(surface_of(plane_wall({0.0, 0.0, 4.0}, {0.0, 0.0, 1.0}), domain).polygons.empty());
}

TEST(WallSurface, ShapesHaveTheirArea) {
  const Wall plate = rectangle_wall({0.1, 0.2, 0.3}, {0.0, 0.0, 2.0}, {0.0, 3.0, 0.0});
  expect_on_wall(surface_of(plate, domain), plate);
  EXPECT_NEAR(area(surface_of(plate, domain)), 6.0, 1e-14);
  const Wall lid = disc_wall({0.1, 0.2, 0.3}, 0.5, {1.0, 2.0, -1.0});
  EXPECT_NEAR(area(surface_of(lid, domain)), 0.25 * pi * polygon_share, 1e-14);
  EXPECT_EQ(surface_of(lid, domain).points.size(), 73U);
  const Wall tube = profile_wall({{0.5, 0.0}, {0.5, 2.0}}, {0.1, 0.2, 0.3}, {3.0, 0.0, 4.0});
  EXPECT_NEAR(area(surface_of(tube, domain)), 2.0 * 72.0 * std::sin(pi / 72.0), 1e-13);
  // Chords lie inside a circle, their ends on it.
  for (const Wall* wall : {&lid, &tube}) {
    for (const Vec3& point : surface_of(*wall, domain).points) EXPECT_LT(distance(*wall, point), 1e-14);
  }
  const Wall ring = profile_wall({{0.5, 0.0}, {0.6, 0.0}, {0.55, 0.1}, {0.5, 0.0}});
  expect_on_wall(surface_of(ring, domain), ring);
  EXPECT_EQ(surface_of(ring, domain).polygons.size(), 3U * 72U);
}

TEST(WallSurface, AMeshHasItsTriangles) {
  const test::Triangles triangles = test::frustum(0.5, -1.0, 1.2, 0.7, 17, 3);
  const Wall wall = make_wall(test::mesh_deck(), 0, [&](const std::string&) { return test::ascii_stl(triangles); });
  expect_on_wall(surface_of(wall, domain), wall);
  EXPECT_EQ(surface_of(wall, domain).polygons.size(), triangles.size());
}

TEST(WallSurface, GoesWhereTheMotionsBringIt) {
  MotionDeck turn;
  turn.type = MotionType::rotation;
  turn.axis_direction = {0.0, 0.0, 1.0};
  turn.angular_velocity = 0.5 * pi;
  MotionDeck lift;
  lift.type = MotionType::translation;
  lift.velocity = {0.0, 0.0, 1.0};
  constexpr double dt = 0.01;
  for (const WallType type : {WallType::plane, WallType::rectangle, WallType::disc}) {
    WallDeck deck;
    deck.name = "moving";
    deck.type = type;
    deck.point = deck.centre = deck.corner = {0.25, 0.0, 0.0};
    deck.normal = {1.0, 0.0, 0.0};
    deck.edge_u = {0.0, 0.5, 0.0};
    deck.edge_v = {0.0, 0.0, 0.5};
    deck.radius = 0.5;
    deck.motions = {turn, lift};
    Wall wall = make_wall(deck, 0);
    const double before = area(surface_of(wall, domain));
    wall.motions.begin_phase("any");
    for (int k = 0; k < 100; ++k) wall.motions.step();
    place(wall, dt);
    const WallSurface surface = surface_of(wall, domain);
    expect_on_wall(surface, wall);
    EXPECT_NEAR(area(surface), before, 1e-13);
    double highest = -10.0;
    for (const Vec3& point : surface.points) {
      EXPECT_NEAR(point.y, 0.25, 1e-14);  // a quarter turn later
      highest = std::max(highest, point.z);
    }
    EXPECT_NEAR(highest, type == WallType::plane ? 3.0 : 1.5, 1e-14);
  }
}

}  // namespace
}  // namespace repose
