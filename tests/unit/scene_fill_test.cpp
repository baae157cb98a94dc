#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "scene/insertion/fill.h"
#include "scene/insertion/overlap.h"
#include "scene/particles/sphere_mass.h"
#include "scene_walls.h"

namespace repose {
namespace {

constexpr double diameter = 440e-6;

// 1.5 g of grains of 440 um in a cylinder of 6 mm radius, 49 mm high.
ParticlesDeck column() {
  ParticlesDeck deck;
  deck.material = "carbohsp";
  deck.diameter = diameter;
  deck.mass = 1.5e-3;
  deck.radius = 6e-3;
  deck.height = 49e-3;
  deck.spacing = 0.78e-3;
  return deck;
}

std::vector<Vec3> fill(const ParticlesDeck& deck, std::int64_t count, const std::vector<Wall>& walls = {},
                       std::uint64_t seed = 1, std::int64_t first_id = 0) {
  return fill_region(deck, count, first_id, seed, walls, "[[particles]] number 1");
}

std::string error_of(const ParticlesDeck& deck, std::int64_t count) {
  try {
    fill(deck, count);
  } catch (const DeckError& error) {
    return error.what();
  }
  return "no error";
}

void expect_apart(const std::vector<Vec3>& positions) {
  const std::vector<double> radius(positions.size(), 0.5 * diameter * (1.0 - 1e-9));
  for_each_overlap(positions, radius, [](std::size_t i, std::size_t j) { ADD_FAILURE() << i << " overlaps " << j; });
}

TEST(Sphere, MassAndInertia) {
  EXPECT_NEAR(sphere_mass(0.5, 1000.0), 1000.0 * pi / 6.0, 1e-12);
  EXPECT_NEAR(sphere_mass(220e-6, 3592.0), 1.60212e-7, 1e-12);
  EXPECT_NEAR(sphere_inertia(2.0, 3.0), 7.2, 1e-15);
}

TEST(FillCount, IsTheMassToWithinOneParticle) {
  const double one = sphere_mass(0.5 * diameter, 3592.0);
  const std::int64_t count = fill_count(column(), 3592.0, "block");
  EXPECT_LE(std::fabs(static_cast<double>(count) * one - 1.5e-3), 0.5 * one);
  ParticlesDeck counted = column();
  counted.count = 17;
  EXPECT_EQ(fill_count(counted, 3592.0, "block"), 17);
  counted.count = 1'000'000'000'000;
  EXPECT_THROW(fill_count(counted, 3592.0, "block"), DeckError);  // 8 TB for the radii alone
}

TEST(FillCount, RefusesNone) {
  ParticlesDeck deck = column();
  deck.mass = 0.4 * sphere_mass(0.5 * diameter, 3592.0);
  EXPECT_THROW(fill_count(deck, 3592.0, "block"), DeckError);
  deck.mass = unset;
  EXPECT_THROW(fill_count(deck, 3592.0, "block"), DeckError);
}

TEST(FillRegion, TheColumnFits) {
  const std::vector<Vec3> grains = fill(column(), 9362);
  ASSERT_EQ(grains.size(), 9362U);
  double top = 0.0;
  for (const Vec3& p : grains) {
    EXPECT_LE(std::hypot(p.x, p.y) + 0.5 * diameter, 6e-3);
    EXPECT_GE(p.z, 0.5 * diameter);
    top = std::fmax(top, p.z + 0.5 * diameter);
  }
  EXPECT_LE(top, 49e-3);
  EXPECT_GT(top, 45e-3);
  expect_apart(grains);
}

TEST(FillRegion, StartsAtTheBottom) {
  for (const Vec3& p : fill(column(), 100)) EXPECT_LE(p.z, 0.78e-3);
}

TEST(FillRegion, IsAFunctionOfSeedAndNumber) {
  EXPECT_EQ(fill(column(), 500), fill(column(), 500));
  EXPECT_NE(fill(column(), 500), fill(column(), 500, {}, 2));
  EXPECT_NE(fill(column(), 500), fill(column(), 500, {}, 1, 500));
  const std::vector<Vec3> few = fill(column(), 300);
  const std::vector<Vec3> many = fill(column(), 500);
  EXPECT_TRUE(std::equal(few.begin(), few.end(), many.begin()));
}

TEST(FillRegion, WithoutJitterIsTheLattice) {
  ParticlesDeck box;
  box.diameter = 1.0;
  box.region = RegionShape::box;
  box.max = {3.0, 2.0, 4.0};
  box.spacing = 1.0;  // exactly 24 spheres
  box.jitter = 0.0;
  const std::vector<Vec3> grains = fill(box, 24);
  EXPECT_EQ(grains.front(), (Vec3{0.5, 0.5, 0.5}));
  EXPECT_EQ(grains.back(), (Vec3{2.5, 1.5, 3.5}));
  EXPECT_THROW(fill(box, 25), DeckError);
}

// The jitter is uniform over the free gap: of 9362 draws per axis the extremes come within 1 % of it.
TEST(FillRegion, JitterUsesTheFreeGap) {
  const double greatest = 0.5 * (0.78e-3 - diameter);
  ParticlesDeck box = column();
  box.region = RegionShape::box;
  box.min = {0.0, 0.0, 0.0};
  box.max = {20e-3, 20e-3, 49e-3};
  const std::vector<Vec3> moved = fill(box, 9362);
  box.min += Vec3{greatest, greatest, greatest};
  box.max -= Vec3{greatest, greatest, greatest};
  box.jitter = 0.0;
  const std::vector<Vec3> sites = fill(box, 9362);
  Vec3 least;
  Vec3 most;
  for (std::size_t i = 0; i < sites.size(); ++i) {
    const Vec3 shift = moved[i] - sites[i];
    least = {std::fmin(least.x, shift.x), std::fmin(least.y, shift.y), std::fmin(least.z, shift.z)};
    most = {std::fmax(most.x, shift.x), std::fmax(most.y, shift.y), std::fmax(most.z, shift.z)};
  }
  for (const double extreme : {-least.x, -least.y, -least.z, most.x, most.y, most.z}) {
    EXPECT_NEAR(extreme, 0.995 * greatest, 0.0051 * greatest);
  }
}

// Distance between the sphere at p and the side of the cone, negative when it reaches through.
double gap_to_side(const ParticlesDeck& cone, const Vec3& p) {
  const double slope = (cone.radius_top - cone.radius) / cone.height;
  const double side = cone.radius + slope * (p.z - cone.centre.z);
  const double rho = std::hypot(p.x - cone.centre.x, p.y - cone.centre.y);
  return (side - rho) / std::sqrt(1.0 + slope * slope) - 0.5 * diameter;
}

TEST(FillRegion, AFrustumHoldsItsSpheres) {
  ParticlesDeck cone = column();
  cone.centre = {1e-3, -2e-3, 3e-3};
  cone.height = 5e-3;
  for (const double jitter : {0.0, 1.0}) {
    for (const auto& [bottom, top] : {std::pair{2e-3, 8e-3}, std::pair{8e-3, 2e-3}}) {
      cone.radius = bottom;
      cone.radius_top = top;
      cone.jitter = jitter;
      double least_gap = 1.0;
      for (std::uint64_t seed = 0; seed < 20; ++seed) {
        for (const Vec3& p : fill(cone, 400, {}, seed)) least_gap = std::fmin(least_gap, gap_to_side(cone, p));
      }
      EXPECT_GE(least_gap, -1e-12);
      EXPECT_LE(least_gap, 0.2 * diameter);  // reaches out to the side
    }
  }
}

TEST(FillRegion, LeavesRoomForWalls) {
  const Wall stem = profile_wall({{2e-3, 0.0}, {2e-3, 49e-3}});
  Wall absent = plane_wall({0.0, 0.0, 10e-3}, {0.0, 0.0, 1.0});
  absent.present = false;
  const std::vector<Vec3> grains = fill(column(), 5000, {stem, absent});
  bool at_absent_wall = false;
  for (const Vec3& p : grains) {
    EXPECT_GE(distance(stem, p), 0.5 * diameter * (1.0 - 1e-8));
    at_absent_wall = at_absent_wall || std::fabs(p.z - 10e-3) < 0.5 * diameter;
  }
  EXPECT_TRUE(at_absent_wall);
}

// A container of the region's own size takes no place away.
TEST(FillRegion, MayTouchWallsAroundIt) {
  const Wall can = profile_wall({{0.0, 0.0}, {6e-3, 0.0}, {6e-3, 60e-3}});
  EXPECT_EQ(fill(column(), 9362, {can}), fill(column(), 9362));
}

TEST(FillRegion, SaysHowManyFitAndWhatWould) {
  ParticlesDeck low = column();
  low.height = 30e-3;
  const std::string error = error_of(low, 9362);
  EXPECT_EQ(error.find("[[particles]] number 1: only "), 0U) << error;
  EXPECT_NE(error.find(" of 9362 particles fit"), std::string::npos) << error;
  const auto number_after = [&](const std::string& words) {
    return std::stod(error.substr(error.find(words) + words.size()));
  };
  const auto fitting = static_cast<std::int64_t>(number_after("only "));
  EXPECT_EQ(fill(low, fitting).size(), static_cast<std::size_t>(fitting));
  EXPECT_THROW(fill(low, fitting + 1), DeckError);
  ParticlesDeck remedied = low;
  remedied.spacing = number_after("; a spacing of ");
  EXPECT_NO_THROW(fill(remedied, 9362)) << error;
  remedied = low;
  remedied.height = number_after("a region of ");
  EXPECT_NO_THROW(fill(remedied, 9362)) << error;
}

TEST(FillRegion, SaysWhenNothingFits) {
  ParticlesDeck narrow = column();
  narrow.radius = 0.4 * diameter;
  EXPECT_NE(error_of(narrow, 1).find("only 0 of 1 particles"), std::string::npos) << error_of(narrow, 1);
  EXPECT_NE(error_of(narrow, 1).find("wider region"), std::string::npos);
}

TEST(FillRegion, RefusesALatticeOfOverlaps) {
  ParticlesDeck dense = column();
  dense.spacing = 0.9 * diameter;
  EXPECT_NE(error_of(dense, 10).find("less than the diameter"), std::string::npos);
}

}  // namespace
}  // namespace repose
