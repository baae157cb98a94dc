#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "scene_samples.h"
#include "scene_walls.h"

namespace repose {
namespace {

constexpr double far = 1e3;

WallTouch only_touch(const Wall& wall, const Vec3& centre, double reach = far) {
  TouchBuffer buffer;
  EXPECT_EQ(find_touches(wall, 0, centre, reach, buffer), 1);
  return buffer[0];
}

TEST(Plane, IsExactAtZeroHeight) {
  const Wall floor = plane_wall({0.3, -0.1, 0.0}, {0.0, 0.0, 0.7});
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const Vec3 centre = draw_point(i, 0, 1.0);
    const WallTouch touch = only_touch(floor, centre);
    EXPECT_EQ(touch.distance, std::fabs(centre.z));
    EXPECT_EQ(touch.normal, (Vec3{0.0, 0.0, centre.z < 0.0 ? -1.0 : 1.0}));
    EXPECT_EQ(touch.point, (Vec3{centre.x, centre.y, 0.0}));
    EXPECT_EQ(distance(floor, centre), touch.distance);
  }
}

TEST(Plane, HasTheDistanceAlongItsNormal) {
  const Wall slope = plane_wall({1.0, 2.0, 3.0}, {1.0, 2.0, -2.0});
  EXPECT_NEAR(only_touch(slope, {1.0, 2.0, 6.0}).distance, 2.0, 1e-15);
  EXPECT_NEAR(only_touch(slope, {1.0, 2.0, 6.0}).normal.z, 2.0 / 3.0, 1e-15);
}

TEST(Wall, IsNotTouchedAtTheReachItself) {
  TouchBuffer buffer;
  EXPECT_EQ(find_touches(plane_wall({}, {0.0, 0.0, 1.0}), 0, {0.0, 0.0, 0.5}, 0.5, buffer), 0);
  EXPECT_EQ(find_touches(disc_wall({}, 1.0), 0, {0.0, 0.0, 0.5}, 0.5, buffer), 0);
  EXPECT_EQ(find_touches(disc_wall({}, 1.0), 0, {1.5, 0.0, 0.0}, 0.5, buffer), 0);
  EXPECT_EQ(find_touches(rectangle_wall({}, {1, 0, 0}, {0, 1, 0}), 0, {0.5, 0.5, 0.5}, 0.5, buffer), 0);
  EXPECT_EQ(find_touches(rectangle_wall({}, {1, 0, 0}, {0, 1, 0}), 0, {1.5, 0.5, 0.0}, 0.5, buffer), 0);
}

// The nearest of a fine grid of points on the surface is at most half a grid diagonal farther than the nearest point.
TEST(Rectangle, HasTheNearestPointOfItsSurface) {
  const Vec3 corner{0.1, -0.2, 0.3};
  const Vec3 u{0.6, 0.8, 0.0};
  const Vec3 v{-0.4, 0.3, 0.0};
  const Wall plate = rectangle_wall(corner, u, v);
  constexpr int n = 200;
  for (std::uint64_t i = 0; i < 100; ++i) {
    const Vec3 centre = draw_point(i, 0, 1.5);
    double brute = far;
    for (int a = 0; a <= n; ++a) {
      for (int b = 0; b <= n; ++b) {
        brute = std::fmin(brute, norm(centre - (corner + (a / double{n}) * u + (b / double{n}) * v)));
      }
    }
    const WallTouch touch = only_touch(plate, centre);
    EXPECT_EQ(distance(plate, centre), touch.distance);
    EXPECT_LE(touch.distance, brute + 1e-14);
    EXPECT_GE(touch.distance, brute - 0.5 * 1.2 / n);
    EXPECT_NEAR(norm(touch.normal), 1.0, 1e-15);
    EXPECT_NEAR(norm(centre - (touch.point + touch.distance * touch.normal)), 0.0, 1e-15);
  }
}

TEST(Rectangle, KnowsItsFaceFromItsEdges) {
  const Wall plate = rectangle_wall({-1.0, -1.0, 0.0}, {2.0, 0.0, 0.0}, {0.0, 2.0, 0.0});
  EXPECT_TRUE(only_touch(plate, {0.5, -0.5, 0.1}).on_face);
  EXPECT_EQ(only_touch(plate, {0.5, -0.5, -0.1}).normal, (Vec3{0.0, 0.0, -1.0}));
  const WallTouch edge = only_touch(plate, {1.3, 0.2, 0.4});
  EXPECT_FALSE(edge.on_face);
  EXPECT_NEAR(edge.distance, 0.5, 1e-15);
  EXPECT_NEAR(edge.normal.x, 0.6, 1e-15);
  const WallTouch corner = only_touch(plate, {2.0, 3.0, -2.0});
  EXPECT_FALSE(corner.on_face);
  EXPECT_NEAR(corner.distance, 3.0, 1e-15);
}

TEST(Disc, HasAFaceAndARimAndNoEdgeAtItsCentre) {
  const Wall lid = disc_wall({1.0, 0.0, 2.0}, 0.5);
  const WallTouch centre = only_touch(lid, {1.0, 0.0, 2.25});
  EXPECT_TRUE(centre.on_face);
  EXPECT_EQ(centre.distance, 0.25);
  EXPECT_EQ(centre.normal, (Vec3{0.0, 0.0, 1.0}));
  EXPECT_TRUE(only_touch(lid, {1.3, 0.39, 1.75}).on_face);
  const WallTouch rim = only_touch(lid, {1.8, 0.0, 2.4});
  EXPECT_FALSE(rim.on_face);
  EXPECT_NEAR(rim.distance, 0.5, 1e-15);
  EXPECT_NEAR(rim.point.x, 1.5, 1e-15);
  EXPECT_NEAR(rim.point.z, 2.0, 1e-15);
  EXPECT_TRUE(adjacent_features(lid, centre.feature, rim.feature));
}

TEST(Disc, CanBeTilted) {
  const Wall lid = disc_wall({}, 1.0, {0.0, 3.0, 4.0});
  const WallTouch touch = only_touch(lid, {0.3, 0.06, 0.08});
  EXPECT_TRUE(touch.on_face);
  EXPECT_NEAR(touch.distance, 0.1, 1e-15);
  EXPECT_NEAR(touch.normal.y, 0.6, 1e-15);
}

TEST(Wall, RefusesShapesWithoutSense) {
  EXPECT_THROW(plane_wall({}, {}), DeckError);
  EXPECT_THROW(disc_wall({}, 0.0), DeckError);
  EXPECT_THROW(disc_wall({}, 1.0, {}), DeckError);
  EXPECT_THROW(rectangle_wall({}, {1, 0, 0}, {}), DeckError);
  EXPECT_THROW(rectangle_wall({}, {1, 0, 0}, {1, 1, 0}), DeckError);
}

}  // namespace
}  // namespace repose
