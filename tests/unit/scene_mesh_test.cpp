#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "contact/wall_contacts.h"
#include "scene/walls/unit_vector.h"
#include "scene/walls/wall.h"
#include "support/meshes.h"

namespace repose::test {
namespace {

constexpr double far = 1e3;

Wall mesh_wall(const Triangles& triangles, WallDeck deck = mesh_deck()) {
  return make_wall(deck, 0, [&](const std::string&) { return ascii_stl(triangles); });
}
const Mesh& mesh_of(const Wall& wall) { return std::get<Mesh>(wall.shape); }

Wall rectangle(const Vec3& corner, const Vec3& u, const Vec3& v) {
  WallDeck deck;
  deck.type = WallType::rectangle;
  deck.corner = corner;
  deck.edge_u = u;
  deck.edge_v = v;
  return make_wall(deck, 0);
}

TouchBuffer touches_of(const Wall& wall, const Vec3& centre, double reach) {
  TouchBuffer buffer;
  find_touches(wall, 0, centre, reach, buffer);
  return buffer;
}

TEST(Mesh, HasTheNearestPointOfItsTriangles) {
  const Triangles triangles = frustum(0.5, -1.0, 1.2, 0.7, 17, 3);
  const Wall wall = mesh_wall(triangles);
  Draw draw(1);
  for (int i = 0; i < 100; ++i) {
    const Vec3 centre = draw.vector(2.0);
    double brute = far;
    for (const Corners& c : triangles) {
      for (int k = 0; k < 2000; ++k) {
        const double u = draw(0.0, 1.0), v = draw(0.0, 1.0 - u);
        if (k == 50 && norm(c[0] - centre) > brute + 1.0) break;  // too far away to matter
        brute = std::fmin(brute, norm(c[0] + u * (c[1] - c[0]) + v * (c[2] - c[0]) - centre));
      }
    }
    const double d = distance(wall, centre);
    EXPECT_LE(d, brute + 1e-14);
    EXPECT_GE(d, brute - 0.05);  // the samples are so near to one another
    EXPECT_TRUE(is_within(wall, centre, d * (1.0 + 1e-6) + 1e-9));
    EXPECT_FALSE(is_within(wall, centre, d * (1.0 - 1e-6) - 1e-5));
    const TouchBuffer buffer = touches_of(wall, centre, far);
    EXPECT_NEAR(buffer[0].distance, d, 1e-12);
    for (const WallTouch& touch : buffer.touches()) {
      EXPECT_NEAR(norm(touch.normal), 1.0, 1e-15);
      EXPECT_NEAR(norm(centre - (touch.point + touch.distance * touch.normal)), 0.0, 1e-14);
      EXPECT_LE(distance(wall, touch.point), 1e-12);
    }
  }
}

// From inside they are touched as faces, from outside each edge and corner once.
TEST(Mesh, ABoxIsSixRectangles) {
  const Vec3 size{1.0, 2.0, 3.0};
  const Wall mesh = mesh_wall(box({}, size));
  EXPECT_EQ(mesh_of(mesh).features.patches.size(), 6U);
  const Vec3 x{size.x, 0, 0}, y{0, size.y, 0}, z{0, 0, size.z};
  const std::vector<Wall> sides = {rectangle({}, x, y), rectangle({}, y, z), rectangle({}, x, z),
                                   rectangle(z, x, y),  rectangle(x, y, z),  rectangle(y, x, z)};
  Draw draw(2);
  int corners = 0;
  for (int i = 0; i < 5000; ++i) {
    const Vec3 centre = {draw(-0.4, 1.4), draw(-0.4, 2.4), draw(-0.4, 3.4)};
    std::multiset<double> expected, found;
    for (const Wall& side : sides) expected.insert(distance(side, centre));
    const bool inside = centre.x > 0.0 && centre.x < size.x && centre.y > 0.0 && centre.y < size.y && centre.z > 0.0 &&
                        centre.z < size.z;
    expected.erase(inside ? expected.lower_bound(0.3) : std::next(expected.begin()), expected.end());
    if (!expected.empty() && *expected.begin() >= 0.3) expected.clear();
    TouchBuffer meshed = touches_of(mesh, centre, 0.3);
    for (const WallTouch& t : meshed.touches()) found.insert(t.distance);
    ASSERT_EQ(expected.size(), found.size()) << centre.x << " " << centre.y << " " << centre.z;
    for (auto a = expected.begin(), b = found.begin(); a != expected.end(); ++a, ++b) EXPECT_NEAR(*a, *b, 1e-15);
    corners += found.size() == 3 ? 1 : 0;
  }
  EXPECT_GT(corners, 10);
}

// Also exactly over its edges and vertices, and where a vertex is missed by rounding.
TEST(Mesh, AFinelyMeshedSquareIsOneFace) {
  const Triangles triangles = irregular_square(1.0, 40);
  const Wall wall = mesh_wall(triangles);
  ASSERT_EQ(mesh_of(wall).features.patches.size(), 1U);
  Draw draw(3);
  const auto expect_one_touch = [&](double x, double y) {
    if (std::fmax(std::fabs(x), std::fabs(y)) > 0.999) return;  // the rim
    const Vec3 centre{x, y, draw(0.001, 0.2)};
    const TouchBuffer buffer = touches_of(wall, centre, 0.3);
    ASSERT_EQ(buffer.size(), 1) << x << " " << y;
    EXPECT_EQ(buffer[0].feature, 0);
    EXPECT_TRUE(buffer[0].on_face);
    EXPECT_EQ(buffer[0].distance, centre.z);
    EXPECT_EQ(buffer[0].normal, (Vec3{0.0, 0.0, 1.0}));
  };
  for (const Corners& c : triangles) {
    const double s = draw(0.0, 1.0);
    for (std::size_t k = 0; k < 3; ++k) {
      expect_one_touch(c[k].x, c[k].y);
      expect_one_touch(std::nextafter(c[k].x, draw(-2.0, 2.0)), c[k].y);
      const Vec3 on_edge = c[k] + s * (c[(k + 1) % 3] - c[k]);
      expect_one_touch(on_edge.x, on_edge.y);
    }
  }
}

// Single precision moves the vertices of a tilted plane off it; it stays one patch.
TEST(Mesh, RoundingOfTheFileDoesNotBreakUpAPlane) {
  Triangles triangles = irregular_square(1.0, 60);
  for (Corners& c : triangles) {
    for (Vec3& p : c) p.z = 0.3 + 0.37 * p.x - 0.21 * p.y;
  }
  const Wall wall = make_wall(mesh_deck(), 0, [&](const std::string&) { return binary_stl(triangles); });
  ASSERT_EQ(mesh_of(wall).features.patches.size(), 1U);
  const Vec3 normal = unit_vector({-0.37, 0.21, 1.0});
  EXPECT_NEAR(norm(cross(mesh_of(wall).features.patches[0].normal, normal)), 0.0, 1e-7);
}

TEST(Mesh, AShallowValleyIsSmoothAndASteepOneACorner) {
  for (const double slope : {0.1, 0.3}) {  // turns by 11.4 and 33.4 degrees
    const Wall valley =
        mesh_wall({{{{0, -9, 0}, {9, 0, 9 * slope}, {0, 9, 0}}}, {{{0, -9, 0}, {-9, 0, 9 * slope}, {0, 9, 0}}}});
    EXPECT_EQ(touches_of(valley, {0.0, 0.0, 1.0}, 1.2).size(), slope < 0.2 ? 1 : 2);
    const TouchBuffer beside = touches_of(valley, {0.01, 0.0, 1.0}, 1.2);
    EXPECT_GT(beside[0].normal.z, 0.9);
    EXPECT_LT(beside[0].normal.x, 0.0);  // the nearer side
    EXPECT_EQ(touches_of(valley, {0.0, 0.0, -1.0}, 1.2).size(), 1);
    EXPECT_FALSE(touches_of(valley, {0.0, 0.0, -1.0}, 1.2)[0].on_face);  // the ridge
    const MeshFeatures& features = mesh_of(valley).features;
    EXPECT_EQ(features.surface[0] == features.surface[1], slope < 0.2);
  }
}

// However many facets there are within reach: what counts fits into the buffer.
TEST(Mesh, FineMeshesDoNotOverflowTheBuffer) {
  const Wall bowl = mesh_wall(frustum(0.1, 0.0, 1.0, 0.2, 400, 30));
  Draw draw(4);
  for (int i = 0; i < 50; ++i) {
    const TouchBuffer buffer = touches_of(bowl, draw.vector(0.5) + Vec3{0.0, 0.0, 0.5}, far);
    EXPECT_FALSE(buffer.overflowed());
    EXPECT_GE(buffer.size(), 1);
  }
}

TEST(Mesh, HistoryPassesBetweenFeaturesThatMeet) {
  const Wall wall = mesh_wall(box({}, {1, 1, 1}));
  const auto feature_at = [&](const Vec3& centre) { return touches_of(wall, centre, 0.2)[0].feature; };
  const int top = feature_at({0.5, 0.5, 1.1});
  const int bottom = feature_at({0.5, 0.5, -0.1});
  const int side = feature_at({1.1, 0.5, 0.5});
  const int edge = feature_at({1.1, 0.5, 1.1});
  const int corner = feature_at({1.1, 1.1, 1.1});
  EXPECT_EQ((std::set<int>{top, bottom, side, edge, corner}).size(), 5U);
  EXPECT_TRUE(adjacent_features(wall, top, edge));
  EXPECT_TRUE(adjacent_features(wall, edge, side));
  EXPECT_TRUE(adjacent_features(wall, corner, top));
  EXPECT_TRUE(adjacent_features(wall, top, side));
  EXPECT_FALSE(adjacent_features(wall, top, bottom));
  EXPECT_FALSE(adjacent_features(wall, edge, bottom));
}

// What keeps_to_face promises: from anywhere within the skin, the face is the only touch.
TEST(Mesh, KeepsToAFaceOnlyWhereNothingElseComesNear) {
  const Wall wall = mesh_wall(frustum(0.5, 0.0, 1.0, 0.3, 24, 2));
  constexpr double radius = 0.05, skin = 0.01;
  Draw draw(5);
  int kept = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 centre = {draw(-1.1, 1.1), draw(-1.1, 1.1), draw(-0.1, 0.4)};
    const TouchBuffer near = touches_of(wall, centre, radius + skin);
    if (near.size() != 1 || !near[0].on_face) continue;
    if (!keeps_to_face(wall, near[0].feature, centre, radius + skin, skin)) continue;
    ++kept;
    const auto face = std::get<FlatFace>(face_of(wall, near[0].feature));
    for (int k = 0; k < 5; ++k) {
      const Vec3 moved = centre + skin * draw.direction();
      const TouchBuffer buffer = touches_of(wall, moved, radius);
      const double height = touch(face, moved).distance;
      ASSERT_EQ(buffer.size(), height < radius ? 1 : 0);
      for (const WallTouch& t : buffer.touches()) EXPECT_EQ(t.distance, height);
    }
  }
  EXPECT_GT(kept, 200);
}

TEST(Mesh, IsScaledThenTurnedThenMoved) {
  WallDeck deck = mesh_deck();
  deck.scale = 0.001;
  deck.rotate_axis = {0.0, 0.0, 3.0};
  deck.rotate_angle = 90.0;
  deck.translate = {0.5, 0.0, 0.0};
  const Wall wall = mesh_wall({{{{0, 0, 0}, {1000, 0, 0}, {0, 2000, 0}}}}, deck);
  EXPECT_EQ(mesh_of(wall).corners[0], (Corners{{{0.5, 0, 0}, {0.5, 1, 0}, {-1.5, 0, 0}}}));
}

TEST(Mesh, RefusesWhatCannotBeAWall) {
  WallDeck deck = mesh_deck();
  const Triangles triangle = {{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}};
  deck.scale = 1e-7;
  EXPECT_THROW(mesh_wall(triangle, deck), DeckError);
  deck.scale = 1e7;
  EXPECT_THROW(mesh_wall(triangle, deck), DeckError);
  deck.scale = 1e300;
  EXPECT_THROW(mesh_wall(triangle, deck), DeckError);
  EXPECT_THROW(mesh_wall({{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}}}), DeckError);
}

TEST(Mesh, AFileOfSinglePrecisionIsFlushWithTheWallBesideIt) {
  constexpr double z = 12.3e-3, radius = 0.5e-3;  // m; z is no number of single precision
  const Triangles half = {{{{-0.01, -0.005, z}, {0, -0.005, z}, {0, 0.005, z}}},
                          {{{-0.01, -0.005, z}, {0, 0.005, z}, {-0.01, 0.005, z}}}};
  const std::vector<Wall> walls = {make_wall(mesh_deck(), 0, [&](const std::string&) { return binary_stl(half); }),
                                   rectangle({0.0, -0.005, z}, {0.01, 0.0, 0.0}, {0.0, 0.01, 0.0})};
  const std::array<std::int32_t, 2> both = {0, 1};
  TouchBuffer touches;
  for (int k = -400; k <= 400; ++k) {
    find_touches_of(walls, both, {{1e-6 * k, 0.0, z + 0.99 * radius}, radius}, radius, touches);
    const auto counts = [](const WallTouch& t) { return t.superseded_by < 0; };
    EXPECT_EQ(std::count_if(touches.touches().begin(), touches.touches().end(), counts), 1) << k;
  }
}

}  // namespace
}  // namespace repose::test
