#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "base/error.h"
#include "measurement/scattering.h"
#include "measurement_piles.h"
#include "pictures/top_view_picture.h"

namespace repose {
namespace {

constexpr double foot = 8.5e-3;

ScatteringDeck plate() {
  ScatteringDeck deck;
  deck.enabled = true;
  deck.plate_min = {-25e-3, -25e-3, 0.0};
  deck.plate_max = {25e-3, 25e-3, 0.0};
  deck.plate_height = 0.0;
  deck.max_height = 20e-3;
  deck.area_1_width = 4.5e-3;
  deck.area_3_radius = 20e-3;
  return deck;
}

/// A pile whose base is a disc of touching grains, in rows, of a given radius, under a cone.
std::vector<Sphere> pile(double radius = foot) {
  constexpr double d = test::diameter;
  std::vector<Sphere> grains = test::cone(0.5 * radius, 30.0);
  for (Sphere& grain : grains) grain.centre.z += 0.8 * d;
  const int half = static_cast<int>(radius / d);
  for (int i = -half; i <= half; ++i) {
    for (int j = -half; j <= half; ++j) {
      if (std::hypot(i * d, j * d) <= radius) grains.push_back({{i * d, j * d, 0.5 * d}, 0.5 * d});
    }
  }
  return grains;
}

/// With 200, 60 and 30 grains around it.
std::vector<Sphere> scene() {
  std::vector<Sphere> grains = pile();
  test::add_strays(grains, 200, 10e-3, 12e-3, 1);
  test::add_strays(grains, 60, 14e-3, 19e-3, 2);
  test::add_strays(grains, 30, 21e-3, 24e-3, 3);
  return grains;
}

Scattering measure(const ScatteringDeck& deck, const std::vector<Sphere>& grains, std::int64_t left = 0) {
  const auto result = scattering(deck, grains, left);
  if (!result) throw std::runtime_error("no base found");
  return *result;
}

/// A sharp edge lies within half a ring, two diameters wide, of where the interpolation finds it.
TEST(BaseRadius, OfAKnownDisc) {
  for (const double radius : {6e-3, 8.3e-3, 8.5e-3, 8.7e-3, 12e-3}) {
    const auto found = base_radius(plate(), pile(radius));
    ASSERT_TRUE(found);
    EXPECT_NEAR(*found, radius, 0.6 * test::diameter) << radius;
  }
}

TEST(BaseRadius, DoesNotMindWhatLiesAround) {
  const double alone = *base_radius(plate(), pile());
  EXPECT_NEAR(*base_radius(plate(), scene()), alone, 0.25 * test::diameter);
  std::vector<Sphere> crowded = pile();
  test::add_strays(crowded, 1500, 9.5e-3, 30e-3, 4);  // more than the 1170 that lie under it
  EXPECT_NEAR(*base_radius(plate(), crowded), alone, 0.25 * test::diameter);
}

/// A crater in the middle, as the first grains leave it, is no edge of the base.
TEST(BaseRadius, LooksOverACrater) {
  std::vector<Sphere> grains = scene();
  std::erase_if(grains, [](const Sphere& g) { return std::hypot(g.centre.x, g.centre.y) < 3e-3 && g.centre.z < 1e-3; });
  EXPECT_NEAR(*base_radius(plate(), grains), *base_radius(plate(), scene()), 0.05 * test::diameter);
}

/// Few grains make the density about the axis uncertain; the densest ring is not that of the pile.
TEST(BaseRadius, DoesNotTakeAFewCrowdedGrainsForThePile) {
  std::vector<Sphere> grains = scene();
  test::add_strays(grains, 40, 0.0, 0.5e-3, 6);
  EXPECT_NEAR(*base_radius(plate(), grains), *base_radius(plate(), scene()), 0.05 * test::diameter);
}

/// What lies upon others does not count: here a wide ring of grains.
TEST(BaseRadius, SeesOnlyWhatLiesOnThePlate) {
  std::vector<Sphere> grains = scene();
  std::vector<Sphere> upper;
  test::add_strays(upper, 3000, 9e-3, 14e-3, 7);
  for (Sphere& grain : upper) grain.centre.z += 0.8 * test::diameter;
  grains.insert(grains.end(), upper.begin(), upper.end());
  EXPECT_NEAR(*base_radius(plate(), grains), *base_radius(plate(), scene()), 0.05 * test::diameter);
}

TEST(BaseRadius, GrowsWhenLessDensityIsEnough) {
  ScatteringDeck deck = plate();
  deck.ring_width = 0.5e-3;
  deck.base_share = 0.9;
  const double dense = *base_radius(deck, scene());
  deck.base_share = 0.1;
  EXPECT_GT(*base_radius(deck, scene()), dense);
}

TEST(BaseRadius, IsAbsentWithoutAPile) {
  std::vector<Sphere> grains;
  test::add_strays(grains, 300, 0.0, 5e-3, 1);
  EXPECT_FALSE(base_radius(plate(), grains));
  EXPECT_FALSE(base_radius(plate(), {}));
  EXPECT_FALSE(scattering(plate(), grains, 0));
}

TEST(Scattering, CountsTheGrainsOfEachArea) {
  const Scattering s = measure(plate(), scene());
  EXPECT_EQ(s.area_1.count, 200);
  EXPECT_EQ(s.area_2->count, 60);
  EXPECT_EQ(s.area_3.count, 30);
  EXPECT_EQ(s.off_plate, 0);
  EXPECT_DOUBLE_EQ(s.area_1.error, std::sqrt(200.0));
  EXPECT_DOUBLE_EQ(s.area_3.error, std::sqrt(30.0));
  EXPECT_EQ(s.area_1.from, *s.measured_base_radius);
  EXPECT_EQ(s.area_1.to, s.area_2->from);
  EXPECT_EQ(s.area_2->to, 20e-3);
  EXPECT_EQ(s.area_3.from, 20e-3);
  EXPECT_FALSE(s.area_3.to);
}

/// Area 3 has the corners of the plate; what lies beyond its edge or below has left it.
TEST(Scattering, EndsAtThePlatesEdge) {
  std::vector<Sphere> grains = scene();
  const double z = 0.5 * test::diameter;
  for (const double x : {24.9e-3, -24.9e-3}) grains.push_back({{x, x, z}, z});    // corners, 35 mm from the axis
  for (const double x : {25.1e-3, -25.1e-3}) grains.push_back({{x, 0.0, z}, z});  // beside it
  grains.push_back({{0.0, 0.0, -1e-3}, z});                                       // below
  grains.push_back({{22e-3, 0.0, 21e-3}, z});                                     // above max_height
  const Scattering s = measure(plate(), grains, 7);
  EXPECT_EQ(s.area_3.count, 32);
  EXPECT_EQ(s.off_plate, 3 + 7);
}

TEST(Scattering, WidenedAreas) {
  ScatteringDeck deck = plate();
  deck.area_1_widened = {11e-3, 1.0};
  deck.area_3_widened = {13e-3, 1e-3};
  const Scattering s = measure(deck, scene());
  EXPECT_EQ(s.area_1_widened.at(0).count, 260);
  EXPECT_EQ(s.area_1_widened.at(1).count, 290);
  EXPECT_EQ(s.area_3_widened.at(0).count, 90);
  EXPECT_EQ(s.area_3_widened.at(1).count, 290);  // at most to the base
  EXPECT_EQ(s.area_3_widened.at(1).from, s.base_radius);
  EXPECT_EQ(s.area_1.count, 200);
}

TEST(Scattering, WithAGivenBase) {
  ScatteringDeck deck = plate();
  deck.base_radius = 13e-3;
  const Scattering s = measure(deck, scene());
  EXPECT_EQ(s.area_1.from, 13e-3);
  EXPECT_NEAR(*s.measured_base_radius, foot, 0.6 * test::diameter);
  std::vector<Sphere> no_pile;
  test::add_strays(no_pile, 60, 14e-3, 16e-3, 2);
  const Scattering without = measure(deck, no_pile);
  EXPECT_FALSE(without.measured_base_radius);
  EXPECT_EQ(without.area_1.count, 60);
  EXPECT_EQ(without.area_3.count, 0);
  EXPECT_EQ(without.area_3.error, 1.0);  // none seen is no proof of none
}

TEST(Scattering, ABoundaryBelongsToTheAreaOutside) {
  ScatteringDeck deck = plate();
  deck.base_radius = 8e-3;
  deck.area_1_width = 4e-3;
  std::vector<Sphere> grains;
  for (const double x : {8e-3, 12e-3, 20e-3, std::nextafter(8e-3, 0.0)}) grains.push_back({{x, 0.0, 1e-3}, 1e-3});
  const Scattering s = measure(deck, grains);
  EXPECT_EQ(s.area_1.count, 1);
  EXPECT_EQ(s.area_2->count, 1);
  EXPECT_EQ(s.area_3.count, 1);
}

TEST(Scattering, HasNoArea2WhereTheOthersMeet) {
  ScatteringDeck deck = plate();
  deck.area_1_width = 15e-3;
  EXPECT_FALSE(measure(deck, scene()).area_2);
  deck.area_3_radius = 5e-3;
  EXPECT_THROW(measure(deck, scene()), DeckError);
}

TEST(Scattering, DoesNotDependOnTheOrderOfTheGrains) {
  const Scattering s = measure(plate(), scene());
  std::vector<Sphere> grains = scene();
  std::mt19937 random(5);
  for (int k = 0; k < 5; ++k) {
    std::shuffle(grains.begin(), grains.end(), random);
    const Scattering again = measure(plate(), grains);
    EXPECT_EQ(again.base_radius, s.base_radius);
    EXPECT_EQ(again.area_1.count, s.area_1.count);
    EXPECT_EQ(again.area_2->count, s.area_2->count);
    EXPECT_EQ(again.area_3.count, s.area_3.count);
  }
}

TEST(Scattering, OffTheOriginAndOnARaisedPlate) {
  ScatteringDeck deck = plate();
  std::vector<Sphere> grains = scene();
  const Vec3 shift{0.1, -0.2, -0.04};
  for (Sphere& grain : grains) grain.centre += shift;
  for (Vec3* v : {&deck.plate_min, &deck.plate_max, &deck.axis}) *v += shift;
  deck.plate_height += shift.z;
  deck.max_height += shift.z;
  const Scattering s = measure(deck, grains);
  EXPECT_NEAR(s.base_radius, measure(plate(), scene()).base_radius, 0.1 * test::diameter);
  EXPECT_EQ(s.area_1.count, 200);
  EXPECT_EQ(s.area_2->count, 60);
  EXPECT_EQ(s.area_3.count, 30);
}

}  // namespace
}  // namespace repose
