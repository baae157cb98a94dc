#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/math.h"
#include "scene/walls/unit_vector.h"
#include "scene_samples.h"
#include "scene_walls.h"

namespace repose {
namespace {

using Points = std::vector<std::array<double, 2>>;
using Features = std::multiset<int>;
constexpr double far = 1e3;
constexpr Vec3 upwards{0.0, 0.0, 1.0};

TouchBuffer touches_of(const Wall& wall, const Vec3& centre, double reach = far) {
  TouchBuffer buffer;
  find_touches(wall, 0, centre, reach, buffer);
  return buffer;
}

Features features_of(const Wall& wall, const Vec3& centre, double reach) {
  Features features;
  const TouchBuffer buffer = touches_of(wall, centre, reach);
  for (const WallTouch& touch : buffer.touches()) features.insert(touch.feature);
  return features;
}

// Lid (segment 1), stem (3), cone (5), cylinder (7), brim (9).
const Points funnel{{0.0, 0.0}, {0.2, 0.0}, {0.2, 0.5}, {0.7, 1.0}, {0.7, 1.6}, {1.0, 1.6}};

// Points of the turned surface, neighbours at most `step` apart along the polyline and around the axis.
std::vector<Vec3> sample_surface(const Points& points, const Vec3& origin, const Vec3& axis, double step) {
  const Vec3 w = unit_vector(axis);
  const Vec3 u = unit_vector(cross(w, std::fabs(w.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
  const Vec3 v = cross(w, u);
  std::vector<Vec3> samples;
  for (std::size_t s = 0; s + 1 < points.size(); ++s) {
    const double dr = points[s + 1][0] - points[s][0];
    const double dz = points[s + 1][1] - points[s][1];
    const int n = static_cast<int>(std::hypot(dr, dz) / step) + 1;
    for (int k = 0; k <= n; ++k) {
      const double r = points[s][0] + dr * k / n;
      const double z = points[s][1] + dz * k / n;
      const int turns = static_cast<int>(2.0 * pi * r / step) + 1;
      for (int t = 0; t < turns; ++t) {
        const double angle = 2.0 * pi * t / turns;
        samples.push_back(origin + r * std::cos(angle) * u + r * std::sin(angle) * v + z * w);
      }
    }
  }
  return samples;
}

TEST(Profile, HasTheNearestPointOfItsSurface) {
  const Vec3 origin{0.1, 0.2, -0.3};
  const Vec3 axis{1.0, -2.0, 2.0};
  constexpr double step = 0.02;
  const std::vector<Vec3> samples = sample_surface(funnel, origin, axis, step);
  const Wall wall = profile_wall(funnel, origin, axis);
  for (std::uint64_t i = 0; i < 200; ++i) {
    const Vec3 centre = draw_point(i, 0, 2.0);
    double brute = far;
    for (const Vec3& s : samples) brute = std::fmin(brute, norm(centre - s));
    const double d = distance(wall, centre);
    EXPECT_LE(d, brute + 1e-14);
    EXPECT_GE(d, brute - step);  // the nearest sample is within half a step each way of the nearest point
    double nearest = far;
    const TouchBuffer buffer = touches_of(wall, centre);
    for (const WallTouch& touch : buffer.touches()) {
      nearest = std::fmin(nearest, touch.distance);
      EXPECT_NEAR(norm(touch.normal), 1.0, 1e-15);
      EXPECT_NEAR(norm(centre - (touch.point + touch.distance * touch.normal)), 0.0, 2e-15);
      EXPECT_LE(distance(wall, touch.point), 2e-15);
    }
    EXPECT_EQ(nearest, d);
  }
}

// Each touch is a local minimum of the distance along the polyline and each local minimum is a touch. Compared with a
// finely sampled polyline, without the centres that project too near to a vertex for the sampling to tell.
TEST(Profile, TouchesAreTheLocalMinimaOfTheDistance) {
  constexpr int n = 4000;
  const Wall wall = profile_wall(funnel);
  Points chain{funnel.front()};
  for (std::size_t s = 0; s + 1 < funnel.size(); ++s) {
    for (int k = 1; k <= n; ++k) {
      const auto along = [&](std::size_t c) { return funnel[s][c] + (funnel[s + 1][c] - funnel[s][c]) * k / n; };
      chain.push_back({along(0), along(1)});
    }
  }
  int compared = 0;
  for (std::uint64_t i = 0; i < 300; ++i) {
    const Vec3 centre{draw(i, 0, -1.2, 1.2), draw(i, 1, -1.2, 1.2), draw(i, 2, -0.5, 2.1)};
    const double rho = std::hypot(centre.x, centre.y);
    std::vector<double> found;
    bool clear = true;
    const TouchBuffer buffer = touches_of(wall, centre);
    for (const WallTouch& touch : buffer.touches()) {
      found.push_back(touch.distance);
      for (const auto& v : funnel) {
        const double to_vertex = std::hypot(std::hypot(touch.point.x, touch.point.y) - v[0], touch.point.z - v[1]);
        if (touch.on_face && to_vertex < 1.0 / n) clear = false;
      }
    }
    if (!clear) continue;
    std::vector<double> minima;
    const auto at = [&](std::size_t k) { return std::hypot(rho - chain[k][0], centre.z - chain[k][1]); };
    for (std::size_t k = 0; k < chain.size(); ++k) {
      const bool below_before = k == 0 || at(k) < at(k - 1);
      const bool below_after = k + 1 == chain.size() || at(k) <= at(k + 1);
      if (below_before && below_after) minima.push_back(at(k));
    }
    std::sort(found.begin(), found.end());
    std::sort(minima.begin(), minima.end());
    ASSERT_EQ(found.size(), minima.size()) << centre.x << " " << centre.y << " " << centre.z;
    for (std::size_t k = 0; k < found.size(); ++k) EXPECT_NEAR(found[k], minima[k], 1.0 / n);
    ++compared;
  }
  EXPECT_GE(compared, 280);
}

TEST(Profile, ConcaveCornersAreTouchedTwiceAndConvexOnesOnce) {
  const Wall wall = profile_wall(funnel);
  constexpr double reach = 0.1;
  EXPECT_EQ(features_of(wall, {0.15, 0.0, 0.05}, reach), (Features{1, 3}));  // corner of lid and stem, inside
  EXPECT_EQ(features_of(wall, {0.0, 0.23, -0.04}, reach), (Features{2}));    // the same, outside
  EXPECT_EQ(features_of(wall, {0.64, 0.0, 1.02}, reach), (Features{5, 7}));  // obtuse corner of cone and cylinder
  EXPECT_EQ(features_of(wall, {0.17, 0.0, 0.505}, reach), (Features{4}));    // stem and cone, convex seen from inside
  EXPECT_EQ(features_of(wall, {0.15, 0.0, 0.45}, reach), (Features{3}));     // ... before it
  EXPECT_EQ(features_of(wall, {0.25, 0.0, 0.65}, reach), (Features{5}));     // ... beyond it
  EXPECT_EQ(features_of(wall, {1.03, 0.0, 1.64}, reach), (Features{10}));    // outer edge of the brim
  EXPECT_EQ(features_of(wall, {0.0, 0.0, 0.05}, reach), (Features{1}));      // the lid's centre is no edge
  EXPECT_EQ(features_of(wall, {0.0, 0.0, 0.25}, reach), (Features{}));
  EXPECT_EQ(touches_of(wall, {1.03, 0.0, 1.64}, reach)[0].on_face, false);
  EXPECT_NEAR(touches_of(wall, {1.03, 0.0, 1.64}, reach)[0].distance, 0.05, 1e-15);
  EXPECT_NEAR(touches_of(wall, {0.15, 0.0, 0.05}, reach)[1].normal.x, -1.0, 1e-15);
}

TEST(Profile, ExactlyOverTheEndOfASegmentItIsTouchedOnce) {
  const Wall wall = profile_wall(funnel);
  EXPECT_EQ(features_of(wall, {1.0, 0.0, 1.65}, 0.1), (Features{9}));
  EXPECT_EQ(features_of(wall, {0.2, 0.0, -0.05}, 0.1), (Features{1}));
  EXPECT_EQ(features_of(wall, {0.25, 0.0, 0.0}, 0.1), (Features{3}));
}

TEST(Profile, AHoleHasARim) {
  const Wall floor = profile_wall({{0.2, 0.0}, {1.0, 0.0}});
  const Vec3 over_the_rim{0.12, 0.09, 0.05};  // rho = 0.15
  const WallTouch rim = touches_of(floor, over_the_rim, 0.1)[0];
  EXPECT_FALSE(rim.on_face);
  EXPECT_NEAR(rim.distance, 0.05 * std::sqrt(2.0), 1e-15);
  EXPECT_NEAR(rim.normal.x, -0.8 / std::sqrt(2.0), 1e-14);
  EXPECT_EQ(touches_of(floor, {0.3, 0.0, 0.05}, 0.1)[0].distance, 0.05);
  EXPECT_EQ(touches_of(floor, {0.3, 0.0, -0.05}, 0.1)[0].normal, -upwards);
  EXPECT_EQ(touches_of(floor, {0.0, 0.0, 0.01}, 0.1).size(), 0);
}

TEST(Profile, ACentreOnTheAxisTouchesAlongAFixedMeridian) {
  for (const Vec3& axis : {upwards, Vec3{1.0, 0.0, 0.0}, Vec3{0.3, -0.4, 0.5}}) {
    const Wall pipe = profile_wall({{0.2, -1.0}, {0.2, 1.0}}, {}, axis);
    const WallTouch touch = touches_of(pipe, {}, 0.3)[0];
    EXPECT_EQ(touches_of(pipe, {}, 0.3).size(), 1);
    EXPECT_NEAR(touch.distance, 0.2, 1e-15);
    EXPECT_NEAR(norm(touch.normal), 1.0, 1e-15);
    EXPECT_NEAR(dot(touch.normal, unit_vector(axis)), 0.0, 1e-15);
    // A hair beside the axis, where rounding is as large as the distance from it.
    for (std::uint64_t i = 0; i < 100; ++i) {
      const Vec3 centre = draw(i, 0, -0.9, 0.9) * unit_vector(axis) + draw_point(i, 1, 1e-17);
      const TouchBuffer buffer = touches_of(pipe, centre, 0.3);
      EXPECT_NEAR(norm(buffer[0].normal), 1.0, 1e-14);
      EXPECT_NEAR(dot(buffer[0].normal, unit_vector(axis)), 0.0, 1e-14);
    }
  }
}

TEST(Profile, AConesTipIsACornerFromOutsideOnly) {
  const Wall cone = profile_wall({{0.0, 1.0}, {1.0, 0.0}});
  EXPECT_EQ(features_of(cone, {0.0, 0.0, 1.1}, 0.2), (Features{0}));
  EXPECT_NEAR(touches_of(cone, {0.0, 0.0, 1.1}, 0.2)[0].distance, 0.1, 1e-15);
  EXPECT_EQ(features_of(cone, {0.0, 0.0, 0.8}, 0.2), (Features{1}));
  EXPECT_NEAR(touches_of(cone, {0.0, 0.0, 0.8}, 0.2)[0].distance, 0.2 / std::sqrt(2.0), 1e-15);
}

// A flat floor cut into many rings is the plane to the bit, also exactly over the seams.
TEST(Profile, ASegmentedFloorIsThePlane) {
  constexpr int n = 64;
  Points points;
  for (int k = 0; k <= n; ++k) points.push_back({k / double{n}, 0.0});
  const Wall rings = profile_wall(points);
  int previous = -1;
  for (int k = 0; k <= 16 * n; ++k) {
    const Vec3 centre{k / (16.0 * n), 0.0, 0.01 + 0.02 * draw(static_cast<std::uint64_t>(k), 0, 0.0, 1.0)};
    const TouchBuffer buffer = touches_of(rings, centre, 0.05);
    ASSERT_EQ(buffer.size(), 1) << centre.x;
    EXPECT_EQ(buffer[0].distance, centre.z);
    EXPECT_EQ(buffer[0].normal, upwards);
    EXPECT_TRUE(buffer[0].on_face);
    if (previous >= 0) {
      EXPECT_TRUE(adjacent_features(rings, previous, buffer[0].feature));
    }
    previous = buffer[0].feature;
  }
}

TEST(Profile, ASegmentedConeIsTheWholeCone) {
  constexpr int n = 37;
  Points points;
  for (int k = 0; k <= n; ++k) points.push_back({0.1 + 0.7 * k / n, 0.3 * k / n});
  const Wall rings = profile_wall(points);
  const Wall whole = profile_wall({points.front(), points.back()});
  for (std::uint64_t i = 0; i < 20000; ++i) {
    const double along = i % 2 == 0 ? draw(i, 0, 0.0, 1.0) : static_cast<double>(i % n) / n;  // half of them over seams
    const double height = draw(i, 1, -0.05, 0.05);
    const double slope = std::hypot(0.7, 0.3);
    const Vec3 centre{0.1 + 0.7 * along - height * 0.3 / slope, 0.0, 0.3 * along + height * 0.7 / slope};
    const TouchBuffer segmented = touches_of(rings, centre, 0.1);
    const TouchBuffer smooth = touches_of(whole, centre, 0.1);
    ASSERT_EQ(segmented.size(), 1) << i;
    ASSERT_EQ(smooth.size(), 1) << i;
    EXPECT_NEAR(segmented[0].distance, smooth[0].distance, 1e-15);
    EXPECT_NEAR(norm(segmented[0].normal - smooth[0].normal), 0.0, 1e-13);
  }
}

TEST(Profile, AClosedChainHasNoEnds) {
  const Wall ring = profile_wall({{0.5, 0.0}, {1.0, 0.0}, {1.0, 0.2}, {0.5, 0.2}, {0.5, 0.0}});
  EXPECT_EQ(features_of(ring, {0.4, 0.0, -0.1}, 0.2), (Features{0}));
  EXPECT_EQ(features_of(ring, {0.45, 0.0, 0.01}, 0.1), (Features{7}));
  EXPECT_EQ(features_of(ring, {0.55, 0.0, -0.05}, 0.1), (Features{1}));
  EXPECT_EQ(features_of(ring, {0.53, 0.0, 0.04}, 0.06), (Features{1, 7}));
  EXPECT_TRUE(adjacent_features(ring, 0, 7));
  EXPECT_TRUE(adjacent_features(ring, 7, 1));
  EXPECT_FALSE(adjacent_features(ring, 1, 5));
  const Wall begins_on_a_face = profile_wall({{0.7, 0.0}, {1.0, 0.0}, {1.0, 0.2}, {0.5, 0.0}, {0.7, 0.0}});
  EXPECT_EQ(features_of(begins_on_a_face, {0.7, 0.0, -0.05}, 0.1).size(), 1U);
}

TEST(Profile, ReportsMoreTouchesThanTheBufferHolds) {
  Points comb;
  for (int k = 0; k < 40; ++k) comb.push_back({1.0 + 0.01 * (k % 2), 0.01 * (k / 2 * 2 + k % 2)});
  TouchBuffer buffer;
  find_touches(profile_wall(comb), 0, {0.0, 0.0, 0.2}, far, buffer);
  EXPECT_TRUE(buffer.overflowed());
  EXPECT_EQ(buffer.size(), TouchBuffer::capacity);
  buffer.clear();
  EXPECT_FALSE(buffer.overflowed());
}

TEST(Profile, RefusesShapesWithoutSense) {
  EXPECT_THROW(profile_wall({{1.0, 0.0}}), DeckError);
  EXPECT_THROW(profile_wall({{-0.1, 0.0}, {1.0, 0.0}}), DeckError);
  EXPECT_THROW(profile_wall({{1.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}}), DeckError);
  EXPECT_THROW(profile_wall({{0.0, 0.0}, {0.0, 1.0}}), DeckError);
  EXPECT_THROW(profile_wall({{0.0, 0.0}, {1.0, 0.0}, {0.5, 0.0}}), DeckError);
  EXPECT_THROW(profile_wall({{0.0, 0.0}, {1.0, 0.0}}, {}, {}), DeckError);
}

}  // namespace
}  // namespace repose
