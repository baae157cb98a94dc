// The bed in a vessel: its bulk density before it is let out, and the slope of what stays.
#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "base/math.h"
#include "measurement/bulk_density.h"
#include "measurement/retained_slope.h"
#include "measurement/sphere_in_box.h"

namespace repose {
namespace {

constexpr double unlimited = 10.0;
constexpr Vec3 far_min = {-unlimited, -unlimited, -unlimited};
constexpr Vec3 far_max = {unlimited, unlimited, unlimited};
constexpr Sphere sphere = {{0.3, -0.2, 0.1}, 1.5};

double cap(double height, double radius) { return pi * height * height * (radius - height / 3.0); }

TEST(SphereInBox, WholeNothingCapAndOctant) {
  EXPECT_DOUBLE_EQ(volume_in_box(sphere, far_min, far_max), volume(sphere));
  EXPECT_EQ(volume_in_box(sphere, {2.0, -unlimited, -unlimited}, far_max), 0.0);
  for (const double x : {-1.1, -0.4, 0.3, 0.35, 1.2, 1.79}) {
    const double height = sphere.centre.x + sphere.radius - x;
    EXPECT_NEAR(volume_in_box(sphere, {x, -unlimited, -unlimited}, far_max), cap(height, sphere.radius), 1e-14);
  }
  EXPECT_NEAR(volume_in_box(sphere, sphere.centre, far_max), volume(sphere) / 8.0, 1e-14);
}

/// By slices: the area of a disc in a rectangle is itself an integral of one variable.
double by_quadrature(const Vec3& min, const Vec3& max) {
  constexpr int n = 1500;
  double sum = 0.0;
  for (int i = 0; i < n; ++i) {
    const double z = min.z + (i + 0.5) * (max.z - min.z) / n;
    for (int j = 0; j < n; ++j) {
      const double y = min.y + (j + 0.5) * (max.y - min.y) / n;
      const double square = sphere.radius * sphere.radius - (z - sphere.centre.z) * (z - sphere.centre.z) -
                            (y - sphere.centre.y) * (y - sphere.centre.y);
      if (square <= 0.0) continue;
      const double half = std::sqrt(square);
      sum += std::max(0.0, std::min(max.x, sphere.centre.x + half) - std::max(min.x, sphere.centre.x - half));
    }
  }
  return sum * (max.y - min.y) * (max.z - min.z) / (1.0 * n * n);
}

TEST(SphereInBox, CutByEdgesAndCorners) {
  const std::pair<Vec3, Vec3> boxes[] = {{{0.5, 0.1, 0.4}, {2.0, 2.0, 2.0}},
                                         {{-0.8, -1.0, -0.9}, {0.9, 0.7, 1.2}},
                                         {{-0.1, -0.3, 0.0}, {0.2, 3.0, 0.3}},
                                         {{-3.0, -1.4, -1.1}, {-0.6, 1.1, 1.4}},
                                         {{1.2, 0.6, 0.9}, {3.0, 3.0, 3.0}}};
  for (const auto& [min, max] : boxes) EXPECT_NEAR(volume_in_box(sphere, min, max), by_quadrature(min, max), 2e-5);
}

/// Boxes that fill space share a sphere among them without loss.
TEST(SphereInBox, PartsAddUp) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> coordinate(-1.4, 1.6);
  for (int round = 0; round < 200; ++round) {
    const auto cuts = [&] {
      std::vector<double> at = {-unlimited, coordinate(generator), coordinate(generator), unlimited};
      std::sort(at.begin(), at.end());
      return at;
    };
    const auto x = cuts(), y = cuts(), z = cuts();
    double sum = 0.0;
    for (std::size_t i = 0; i < 27; ++i) {
      const std::size_t a = i % 3, b = i / 3 % 3, c = i / 9;
      sum += volume_in_box(sphere, {x[a], y[b], z[c]}, {x[a + 1], y[b + 1], z[c + 1]});
    }
    EXPECT_NEAR(sum / volume(sphere), 1.0, 1e-13);
  }
}

constexpr double spacing = 1e-3;
constexpr double density = 2500.0;

struct Bed {
  std::vector<Sphere> grains;
  std::vector<double> mass;

  void add(const Vec3& centre, double radius) {
    grains.push_back({centre, radius});
    mass.push_back(density * volume(grains.back()));
  }
  auto measured(const BulkDensityDeck& deck, const DomainDeck& domain = {{-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}}) const {
    return bulk_density(deck, domain, grains, mass);
  }
};

/// A cubic lattice from 0 to n cells along each axis.
Bed lattice(int n, double radius) {
  Bed bed;
  for (int i = 0; i < n * n * n; ++i) {
    bed.add({spacing * (i % n + 0.5), spacing * (i / n % n + 0.5), spacing * (i / n / n + 0.5)}, radius);
  }
  return bed;
}

/// Each cell of a box that is a whole number of cells long holds a whole sphere, wherever the box stands.
TEST(BulkDensity, OfALattice) {
  for (const double radius : {0.31e-3, 0.5e-3}) {
    const Bed bed = lattice(14, radius);
    const double solid = volume({{}, radius}) / (spacing * spacing * spacing);
    for (const double shift : {0.0, 0.13e-3, 0.5e-3, 0.777e-3}) {
      const BulkDensityDeck deck = {.enabled = true,
                                    .min = {2e-3 + shift, 3e-3 - shift, 1e-3 + 0.3 * shift},
                                    .max = {7e-3 + shift, 9e-3 - shift, 8e-3 + 0.3 * shift},
                                    .surface_gap = 1e-3};
      const auto found = bed.measured(deck);
      ASSERT_TRUE(found);
      EXPECT_NEAR(*found->density / (density * solid), 1.0, 1e-12);
      EXPECT_NEAR(found->porosity, 1.0 - solid, 1e-12);
      EXPECT_EQ(found->top, deck.max.z);
    }
  }
}

/// 8 periodic cells: the box takes the whole domain across.
TEST(BulkDensity, OfAPeriodicLattice) {
  const Bed bed = lattice(8, 0.5e-3);
  const DomainDeck domain = {
      .min = {0.3e-3, 0.3e-3, -1e-3}, .max = {8.3e-3, 8.3e-3, 1.0}, .periodic = {Axis::x, Axis::y}};
  Bed wrapped;
  for (const Sphere& grain : bed.grains) wrapped.add(grain.centre, grain.radius);
  const BulkDensityDeck deck = {.enabled = true,
                                .min = {domain.min.x, domain.min.y, 2e-3},
                                .max = {domain.max.x, domain.max.y, 5e-3},
                                .surface_gap = 1e-3};
  const auto found = wrapped.measured(deck, domain);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->porosity, 1.0 - pi / 6.0, 1e-12);
}

/// Grains of three sizes at random places, which overlap no other.
Bed random_bed() {
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> coordinate(0.0, 10e-3), choice(0.0, 1.0);
  Bed bed;
  for (int attempt = 0; attempt < 20000; ++attempt) {
    const Sphere next = {{coordinate(generator), coordinate(generator), coordinate(generator)},
                         choice(generator) < 0.3   ? 0.7e-3
                         : choice(generator) < 0.5 ? 0.4e-3
                                                   : 0.25e-3};
    const auto meets = [&](const Sphere& other) {
      return norm(next.centre - other.centre) < next.radius + other.radius;
    };
    if (std::none_of(bed.grains.begin(), bed.grains.end(), meets)) bed.add(next.centre, next.radius);
  }
  return bed;
}

constexpr BulkDensityDeck inner_box = {
    .enabled = true, .min = {1.1e-3, 2.3e-3, 1.7e-3}, .max = {7.9e-3, 8.6e-3, 8e-3}, .surface_gap = 0.0};

TEST(BulkDensity, OfARandomBedByCounting) {
  const Bed bed = random_bed();
  const auto found = bed.measured(inner_box);
  ASSERT_TRUE(found);
  std::mt19937 generator(12);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator);
  };
  constexpr int points = 100000;
  int solid = 0;
  for (int i = 0; i < points; ++i) {
    const Vec3 p = {between(inner_box.min.x, inner_box.max.x), between(inner_box.min.y, inner_box.max.y),
                    between(inner_box.min.z, found->top)};
    solid += std::any_of(bed.grains.begin(), bed.grains.end(),
                         [&](const Sphere& grain) { return norm(p - grain.centre) < grain.radius; })
                 ? 1
                 : 0;
  }
  const double share = static_cast<double>(solid) / points;
  EXPECT_NEAR(found->porosity, 1.0 - share, 4.0 * std::sqrt(share * (1.0 - share) / points));
  EXPECT_NEAR(*found->density, density * (1.0 - found->porosity), 1e-9);
  const auto without_mass = bulk_density(inner_box, {{-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}}, bed.grains, {});
  ASSERT_TRUE(without_mass);
  EXPECT_EQ(without_mass->porosity, found->porosity);
  EXPECT_FALSE(without_mass->density);
}

TEST(BulkDensity, DoesNotDependOnTheOrderOfTheGrains) {
  Bed bed = random_bed();
  const auto before = bed.measured(inner_box);
  std::reverse(bed.grains.begin(), bed.grains.end());
  std::reverse(bed.mass.begin(), bed.mass.end());
  const auto after = bed.measured(inner_box);
  ASSERT_TRUE(before && after);
  EXPECT_EQ(before->density, after->density);
  EXPECT_EQ(before->porosity, after->porosity);
}

/// A bed whose surface is lower on one side, and a grain in flight.
TEST(BulkDensity, TheBoxEndsBelowTheSurface) {
  Bed bed = lattice(12, 0.5e-3);
  const auto is_high = [](const Sphere& grain) { return grain.centre.x < 6e-3 && grain.centre.z > 9e-3; };
  std::erase_if(bed.grains, is_high);
  bed.mass.resize(bed.grains.size());
  bed.add({5e-3, 5e-3, 30e-3}, 0.5e-3);
  const BulkDensityDeck deck = {.enabled = true, .min = {2e-3, 2e-3, 2e-3}, .max = {10e-3, 10e-3, 40e-3}};
  const auto found = bed.measured(deck);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->top, 9e-3 - 3e-3, 1e-12);
  EXPECT_NEAR(found->porosity, 1.0 - pi / 6.0, 1e-12);
}

TEST(BulkDensity, NoneWithoutABedThatIsDeepEnough) {
  const BulkDensityDeck deck = {.enabled = true, .min = {1e-3, 1e-3, 1e-3}, .max = {7e-3, 7e-3, 7e-3}};
  EXPECT_FALSE(Bed().measured(deck));
  EXPECT_FALSE(lattice(5, 0.5e-3).measured(deck));  // does not reach over the whole box
  Bed low = lattice(8, 0.5e-3);
  std::erase_if(low.grains, [](const Sphere& grain) { return grain.centre.z > 5e-3; });
  EXPECT_FALSE(low.measured(deck));
}

/// What a cylinder of 20 mm keeps above a crater that rises by `degrees` from a hole of 3 mm to a plain at 10 mm, in
/// columns of touching grains.
std::vector<Sphere> crater(double degrees) {
  constexpr double d = 0.5e-3;
  std::vector<Sphere> grains;
  for (int i = -40; i <= 40; ++i) {
    for (int j = -40; j <= 40; ++j) {
      const double r = std::hypot(i * d, j * d);
      if (r > 20e-3 - 0.5 * d) continue;
      const double surface = std::min(10e-3, std::tan(degrees * pi / 180.0) * (r - 3e-3));
      for (int k = 0; (k + 0.5) * d < surface; ++k) grains.push_back({{i * d, j * d, (k + 0.5) * d}, 0.5 * d});
    }
  }
  return grains;
}

constexpr RetainedSlopeDeck vessel = {.enabled = true, .orifice_height = 0.0, .axis = {}, .radius = 20e-3};

TEST(RetainedSlope, OfACrater) {
  for (const double degrees : {20.0, 30.0, 40.0}) {
    const auto slope = retained_slope(vessel, crater(degrees));
    ASSERT_TRUE(slope);
    EXPECT_NEAR(*slope * 180.0 / pi, degrees, 1.0);  // rings are two grains wide
  }
}

TEST(RetainedSlope, GrainsThatFlyOrHaveFallenDoNotCount) {
  std::vector<Sphere> grains = crater(30.0);
  const auto without = retained_slope(vessel, grains);
  grains.push_back({{1e-3, 1e-3, 15e-3}, 0.25e-3});
  grains.push_back({{1e-3, 1e-3, -15e-3}, 0.25e-3});
  EXPECT_EQ(retained_slope(vessel, grains), without);
}

TEST(RetainedSlope, NoneWithoutABedThatRises) {
  EXPECT_FALSE(retained_slope(vessel, {}));
  std::vector<Sphere> flat = crater(30.0);
  std::erase_if(flat, [](const Sphere& grain) {
    return grain.centre.z > 1e-3 || std::hypot(grain.centre.x, grain.centre.y) < 6e-3;
  });
  EXPECT_FALSE(retained_slope(vessel, flat));
}

}  // namespace
}  // namespace repose
