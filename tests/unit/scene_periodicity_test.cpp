#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "base/error.h"
#include "deck/deck.h"
#include "deck_error.h"
#include "scene/particles/periodicity.h"
#include "scene/walls/periodic_walls.h"
#include "scene_samples.h"

namespace repose {
namespace {

const DomainDeck box = {{-0.1, 0.03, -0.2}, {0.3, 0.07, 0.5}, {Axis::x, Axis::y}};

// What everything rests on: a shift by a length rounds nothing, wherever the particle is and whichever way it makes.
TEST(Periodicity, ShiftsByALengthAreExact) {
  const Periodicity periodic(box);
  const Vec3 length = periodic.length();
  EXPECT_NEAR(length.x, 0.4, 1e-15);
  EXPECT_NEAR(length.y, 0.04, 1e-15);
  EXPECT_EQ(length.z, 0.0);
  const Vec3 grid = periodic.rounding();
  for (std::uint64_t i = 0; i < 1000; ++i) {
    Vec3 x = periodic.on_grid({draw(i, 0, -0.1, 0.3), draw(i, 1, 0.03, 0.07), draw(i, 2, -0.2, 0.5)});
    Vec3 image = x + length;
    EXPECT_EQ(image - length, x);
    for (std::uint32_t k = 0; k < 10; ++k) {
      const Vec3 way = std::ldexp(1.0, -2 * static_cast<int>(k)) * draw_point(i, 3 + 3 * k, 1e-3);
      const Vec3 rounded = (way + grid) - grid;
      EXPECT_NEAR(rounded.x, way.x, std::ldexp(1.0, -53));  // half a spacing
      EXPECT_EQ(rounded.z, way.z);
      x += rounded;
      image += rounded;
      EXPECT_EQ(image.x - length.x, x.x);
      EXPECT_EQ(image.y - length.y, x.y);
      EXPECT_EQ(periodic.wrapped(x).x, periodic.wrapped(image).x);
    }
  }
}

TEST(Periodicity, WrapsIntoTheDomainAlone) {
  const Periodicity periodic(box);
  const Vec3 inside = periodic.on_grid({0.1, 0.05, 0.0});
  EXPECT_EQ(periodic.wrapped(inside), inside);
  const Vec3 beyond = {inside.x + periodic.length().x, inside.y - periodic.length().y, 17.0};
  EXPECT_EQ(periodic.wrapped(beyond), (Vec3{inside.x, inside.y, 17.0}));
  const Vec3 top = periodic.on_grid({0.3 + 1e-16, 0.07, 0.5});  // the upper bounds are the lower ones
  EXPECT_NEAR(top.x, -0.1, 1e-15);
  EXPECT_NEAR(top.y, 0.03, 1e-15);
  EXPECT_EQ(top.z, 0.5);
  EXPECT_FALSE(Periodicity().any());
  EXPECT_EQ(Periodicity().wrapped({5.0, 6.0, 7.0}), (Vec3{5.0, 6.0, 7.0}));
}

TEST(Periodicity, ShiftsThatComeNear) {
  const Periodicity periodic(box);
  const auto shifts = [&](const Vec3& x) {
    std::set<std::pair<int, int>> found;
    periodic.for_each_shift(x, 0.01, [&](const Vec3& shift) {
      EXPECT_EQ(shift.z, 0.0);
      found.insert({static_cast<int>(std::lround(shift.x / 0.4)), static_cast<int>(std::lround(shift.y / 0.04))});
    });
    return found;
  };
  using Set = std::set<std::pair<int, int>>;
  EXPECT_EQ(shifts({0.1, 0.05, -0.199}), (Set{{0, 0}}));
  EXPECT_EQ(shifts({-0.095, 0.05, 0.0}), (Set{{0, 0}, {1, 0}}));
  EXPECT_EQ(shifts({0.295, 0.031, 0.0}), (Set{{0, 0}, {-1, 0}, {0, 1}, {-1, 1}}));
}

TEST(Periodicity, StaysInsideOnlyAwayFromTheBoundaries) {
  const Periodicity periodic(box);
  EXPECT_TRUE(periodic.stays_inside({0.1, 0.05, 0.5}, 0.015));
  EXPECT_FALSE(periodic.stays_inside({0.1, 0.05, 0.5}, 0.025));
  EXPECT_FALSE(periodic.stays_inside({0.295, 0.05, 0.5}, 0.01));
  EXPECT_FALSE(periodic.stays_inside({0.7, 0.05, 0.5}, 0.01));
  EXPECT_TRUE(Periodicity().stays_inside({1e20, 0.0, 0.0}, 1.0));
}

TEST(Periodicity, TheSkinIsAQuarterOfTheShortestLengthLessARadius) {
  EXPECT_NEAR(longest_skin(Periodicity(box), 0.004), 0.006, 1e-15);
  EXPECT_TRUE(std::isinf(longest_skin(Periodicity(), 0.004)));
  const auto message = [](std::string_view further) {
    return test::deck_error([&] { longest_skin(Periodicity(box), 0.0081, further); });
  };
  EXPECT_EQ(message(""),
            "domain.periodic: the domain is 0.04 m long, less than 2.5 times the largest diameter 0.0162 m, so that a "
            "particle would meet its own image; enlarge it to 0.0405 m");
  EXPECT_EQ(message("phase.growth"),
            "domain.periodic: the domain is 0.04 m long, less than 5 times the largest reach 0.0081 m of a particle "
            "(with phase.growth), so that a particle would meet its own image; enlarge it to 0.0405 m");
}

WallDeck rectangle(const Vec3& corner, const Vec3& u, const Vec3& v) {
  WallDeck wall;
  wall.name = "sheet";
  wall.type = WallType::rectangle;
  wall.corner = corner;
  wall.edge_u = u;
  wall.edge_v = v;
  return wall;
}

void expect_walls(bool meet, const std::vector<WallDeck>& decks) {
  std::vector<Wall> walls;
  for (const WallDeck& deck : decks) walls.push_back(make_wall(deck, 0));
  if (meet) {
    EXPECT_NO_THROW(check_walls_meet(box, walls, 0.002));
  } else {
    EXPECT_THROW(check_walls_meet(box, walls, 0.002), DeckError);
  }
}

TEST(PeriodicWalls, MustGoOnAcrossTheBoundary) {
  WallDeck plane;
  plane.point = {0.0, 0.0, 0.0};
  expect_walls(true, {});
  expect_walls(true, {plane});
  plane.normal = {0.01, 0.0, 1.0};
  expect_walls(false, {plane});
  const WallDeck whole = rectangle({-0.1, 0.03, 0.0}, {0.4, 0, 0}, {0, 0.04, 0});
  const WallDeck half = rectangle({-0.1, 0.03, 0.0}, {0.2, 0, 0}, {0, 0.04, 0});
  const WallDeck rest = rectangle({0.1, 0.03, 0.0}, {0.2, 0, 0}, {0, 0.04, 0});
  expect_walls(true, {whole});
  expect_walls(false, {half});
  expect_walls(true, {half, rest});
  expect_walls(true, {whole, rectangle({0.0, 0.04, 0.1}, {0, 0.01, 0}, {0, 0, 0.1})});    // far from the boundaries
  expect_walls(false, {whole, rectangle({0.0, 0.031, 0.1}, {0, 0.01, 0}, {0, 0, 0.1})});  // too near to one
}

}  // namespace
}  // namespace repose
