#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "scene_walls.h"

namespace repose {
namespace {

constexpr double radius = 0.05;

TouchBuffer resolved(const std::vector<Wall>& walls, const Vec3& centre) {
  TouchBuffer buffer;
  for (std::size_t w = 0; w < walls.size(); ++w) find_touches(walls[w], static_cast<int>(w), centre, radius, buffer);
  double tolerance = 1e-9 * radius;
  for (const Wall& wall : walls) tolerance = std::max(tolerance, flatness(wall));
  resolve_touches(buffer, tolerance);
  return buffer;
}

// Walls of the touches that count.
std::vector<int> counting_walls(const TouchBuffer& buffer) {
  std::vector<int> walls;
  for (const WallTouch& touch : buffer.touches()) {
    if (touch.superseded_by < 0) walls.push_back(touch.wall);
  }
  return walls;
}

using Walls = std::vector<int>;

TEST(ResolveTouches, LidAndFloorAreOneSurface) {
  const std::vector<Wall> walls{profile_wall({{0.2, 0.0}, {1.0, 0.0}}), disc_wall({}, 0.2)};
  for (int k = 0; k <= 1000; ++k) {
    const Vec3 centre{0.15 + 1e-4 * k, 0.0, 0.045};
    const TouchBuffer buffer = resolved(walls, centre);
    ASSERT_EQ(counting_walls(buffer).size(), 1U) << centre.x;
    for (const WallTouch& touch : buffer.touches()) {
      if (touch.superseded_by >= 0) {
        EXPECT_EQ(buffer[touch.superseded_by].superseded_by, -1);
        continue;
      }
      EXPECT_TRUE(touch.on_face);
      EXPECT_EQ(touch.distance, 0.045);
    }
  }
  EXPECT_EQ(counting_walls(resolved(walls, {0.21, 0.0, 0.045})), Walls{0});
  EXPECT_EQ(counting_walls(resolved(walls, {0.19, 0.0, 0.045})), Walls{1});
  EXPECT_EQ(counting_walls(resolved(walls, {0.2, 0.0, 0.045})), Walls{0});  // both faces: the lower index
}

TEST(ResolveTouches, TheEdgeNamesTheFaceThatInheritsItsHistory) {
  const TouchBuffer buffer = resolved({profile_wall({{0.2, 0.0}, {1.0, 0.0}}), disc_wall({}, 0.2)}, {0.19, 0.0, 0.045});
  ASSERT_EQ(buffer.size(), 2);
  EXPECT_EQ(buffer[0].wall, 0);
  EXPECT_EQ(buffer[0].superseded_by, 1);
}

// The stem's edge gives way to the floor's rim at the same place, and that to the lid.
TEST(ResolveTouches, TheHeirIsATouchThatCounts) {
  const std::vector<Wall> walls{profile_wall({{0.2, 0.0}, {1.0, 0.0}}), profile_wall({{0.2, -0.5}, {0.2, 0.0}}),
                                disc_wall({}, 0.2)};
  const TouchBuffer buffer = resolved(walls, {0.19, 0.0, 0.045});
  ASSERT_EQ(buffer.size(), 3);
  EXPECT_EQ(buffer[0].superseded_by, 2);
  EXPECT_EQ(buffer[1].superseded_by, 2);
  EXPECT_EQ(counting_walls(buffer), Walls{2});
}

TEST(ResolveTouches, WithoutTheLidTheRimCounts) {
  EXPECT_EQ(counting_walls(resolved({profile_wall({{0.2, 0.0}, {1.0, 0.0}})}, {0.19, 0.0, 0.045})), Walls{0});
}

TEST(ResolveTouches, ALidBelowTheFloorLeavesTheRim) {
  const std::vector<Wall> walls{profile_wall({{0.2, 0.0}, {1.0, 0.0}}), disc_wall({0.0, 0.0, -0.001}, 0.2)};
  EXPECT_EQ(counting_walls(resolved(walls, {0.19, 0.0, 0.045})), (Walls{0, 1}));
}

TEST(ResolveTouches, TwoRimsAtTheSamePlaceCountOnce) {
  const std::vector<Wall> walls{profile_wall({{0.2, 0.0}, {1.0, 0.0}}),
                                profile_wall({{0.2, -0.5}, {0.2, 0.0}})};  // with a stem
  EXPECT_EQ(counting_walls(resolved(walls, {0.18, 0.0, 0.03})), Walls{0});
  EXPECT_EQ(counting_walls(resolved(walls, {0.22, 0.0, 0.03})), Walls{0});   // the stem's edge lies in the floor
  EXPECT_EQ(counting_walls(resolved(walls, {0.18, 0.0, -0.03})), Walls{1});  // the floor's rim lies in the stem
  EXPECT_EQ(counting_walls(resolved(walls, {0.22, 0.0, -0.03})), (Walls{0, 1}));
}

// A groove narrower than the sphere: its far edge is flush with the face the sphere rests on.
TEST(ResolveTouches, AFlushEdgeOfTheSameWallGivesWayToo) {
  const Wall grooved = profile_wall({{0.3, 0.0}, {0.3, -0.1}, {0.31, -0.1}, {0.31, 0.0}, {1.0, 0.0}});
  const TouchBuffer buffer = resolved({grooved}, {0.311, 0.0, 0.045});
  EXPECT_EQ(buffer.size(), 2);
  EXPECT_EQ(counting_walls(buffer), Walls{0});
}

TEST(ResolveTouches, AConcaveCornerOfTwoWallsStaysTwoTouches) {
  const std::vector<Wall> walls{plane_wall({}, {0, 0, 1}), plane_wall({}, {1, 0, 0}), plane_wall({}, {0, 1, 0})};
  EXPECT_EQ(counting_walls(resolved(walls, {0.04, 0.04, 0.04})), (Walls{0, 1, 2}));
  const std::vector<Wall> can{disc_wall({}, 0.2), profile_wall({{0.2, 0.0}, {0.2, 1.0}})};
  EXPECT_EQ(counting_walls(resolved(can, {0.16, 0.0, 0.04})), (Walls{0, 1}));
}

TEST(ResolveTouches, TheSameSurfaceThreeTimesCountsOnce) {
  const std::vector<Wall> walls{disc_wall({}, 0.2), plane_wall({}, {0, 0, -1}), plane_wall({0.3, 0.4, 0.0}, {0, 0, 1})};
  EXPECT_EQ(counting_walls(resolved(walls, {0.1, 0.0, 0.04})), Walls{0});
  const TouchBuffer beyond_the_rim = resolved(walls, {0.21, 0.0, 0.04});
  EXPECT_EQ(counting_walls(beyond_the_rim), Walls{1});
  EXPECT_EQ(beyond_the_rim[0].superseded_by, 1);
  EXPECT_EQ(beyond_the_rim[2].superseded_by, 1);
}

}  // namespace
}  // namespace repose
