// What leaves the domain: faces, counts, masses, parking.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "domain/exits.h"
#include "scene/particles/sphere_mass.h"

namespace repose::test {
namespace {

MaterialTable one_material() {
  Deck deck;
  deck.materials = {{"grain", 1e7, 0.3, 2500.0}};
  deck.pairs = {{{0.5, 0.5, 0.1}, {"grain", "grain"}}};
  return MaterialTable(deck);
}

const DomainDeck domain = {{-1.0, -2.0, -3.0}, {1.0, 2.0, 3.0}};

struct Exits {
  MaterialTable materials = one_material();
  MassUnit unit{1.0};
  Particles particles;
  ExitCount left;
  std::vector<ExitDeck> exits;

  std::size_t add(const Vec3& position, double radius = 0.01) {
    particles.record.push_back({position, radius, {1.0, 2.0, 3.0}, 1.0, {4.0, 5.0, 6.0}, 1.0});
    particles.id.push_back(static_cast<std::int64_t>(particles.owned++));
    particles.material.push_back(0);
    return particles.owned - 1;
  }
  void retire() { retire_leavers(domain, exits, materials, unit, particles, left); }
};

TEST(Exits, EachFaceIsCountedWithItsMass) {
  Exits e;
  const Vec3 beyond[6] = {{-1.1, 0.0, 0.0}, {1.1, 0.0, 0.0},  {0.0, -2.1, 0.0},
                          {0.0, 2.1, 0.0},  {0.0, 0.0, -3.1}, {0.0, 0.0, 3.1}};
  for (std::size_t face = 0; face < 6; ++face) {
    for (std::size_t n = 0; n <= face; ++n) e.add(beyond[face], 0.01 + 0.001 * static_cast<double>(n));
  }
  e.add({0.0, 0.0, 0.0});
  e.retire();
  for (std::size_t face = 0; face < 6; ++face) {
    std::int64_t mass = 0;
    for (std::size_t n = 0; n <= face; ++n) {
      mass += e.unit.count(sphere_mass(0.01 + 0.001 * static_cast<double>(n), 2500.0));
    }
    EXPECT_EQ(e.left.particles[face], static_cast<std::int64_t>(face + 1)) << exit_names[face];
    EXPECT_EQ(e.left.mass[face], mass) << exit_names[face];
  }
}

TEST(Exits, APositionThatIsNoNumberHasNotLeft) {
  Exits e;
  e.add({0.0, std::nan(""), 0.0});
  e.retire();
  EXPECT_FALSE(is_parked(e.particles.record[0]));
  EXPECT_EQ(e.left.particles, (std::array<std::int64_t, 6>{}));
}

TEST(Exits, TheFaceFurthestBehindCounts) {
  Exits e;
  e.add({1.1, 2.2, 3.1});
  e.add({-1.3, -2.2, 3.1});
  e.retire();
  EXPECT_EQ(e.left.particles, (std::array<std::int64_t, 6>{1, 0, 0, 1, 0, 0}));
}

// As at insertion: the lower faces belong to the domain, the upper ones do not.
TEST(Exits, LowerFacesAreInsideUpperOnesOutside) {
  Exits e;
  for (const double x : {-1.0, 0.0, std::nextafter(1.0, 0.0)}) {
    for (const double y : {-2.0, 0.0, std::nextafter(2.0, 0.0)}) {
      for (const double z : {-3.0, 0.0, std::nextafter(3.0, 0.0)}) e.add({x, y, z});
    }
  }
  e.retire();
  EXPECT_EQ(std::count_if(e.particles.record.begin(), e.particles.record.end(), is_parked), 0);
  const Vec3 outside[6] = {{1.0, 0.0, 0.0},
                           {0.0, 2.0, 0.0},
                           {0.0, 0.0, 3.0},
                           {std::nextafter(-1.0, -2.0), 0.0, 0.0},
                           {0.0, std::nextafter(-2.0, -3.0), 0.0},
                           {0.0, 0.0, std::nextafter(-3.0, -4.0)}};
  for (std::size_t i = 0; i < 6; ++i) e.particles.record[i].position = outside[i];
  e.retire();
  EXPECT_EQ(std::count_if(e.particles.record.begin(), e.particles.record.end(), is_parked), 6);
  EXPECT_EQ(e.left.particles, (std::array<std::int64_t, 6>{1, 1, 1, 1, 1, 1}));
}

TEST(Exits, NamedPartsOfAFaceAreCountedByName) {
  Exits e;
  e.exits = {{"hole", DomainFace::z_min, {-0.5, -0.5, 7.0}, {0.5, 0.5, 7.0}},  // z does not matter
             {"around", DomainFace::z_min, {-0.8, -2.0, 0.0}, {0.8, 2.0, 0.0}},
             {"side", DomainFace::x_max}};
  e.add({0.0, 0.0, -3.1}, 0.02);   // hole; also around, but the first counts
  e.add({-0.5, 0.4, -3.1}, 0.03);  // hole: its lower edge belongs to it
  e.add({0.5, 0.4, -3.1}, 0.04);   // around: the upper edge of the hole does not belong to it
  e.add({0.9, 0.0, -3.1}, 0.05);   // beside both
  e.add({1.1, 0.0, 0.0}, 0.06);    // side
  e.add({0.0, 0.0, 3.1}, 0.07);    // the top has no part
  e.retire();
  const auto mass = [&](double radius) { return e.unit.count(sphere_mass(radius, 2500.0)); };
  EXPECT_EQ(e.left.particles, (std::array<std::int64_t, 6>{0, 1, 0, 0, 4, 1}));
  EXPECT_EQ(e.left.named_particles, (std::vector<std::int64_t>{2, 1, 1}));
  EXPECT_EQ(e.left.named_mass, (std::vector<std::int64_t>{mass(0.02) + mass(0.03), mass(0.04), mass(0.06)}));

  const std::vector<ExitTotal> totals = exit_totals(e.exits, e.left);
  ASSERT_EQ(totals.size(), 9U);
  EXPECT_EQ(totals[4].name, "z_min");
  EXPECT_EQ(totals[4].particles, 1);
  EXPECT_EQ(totals[4].mass, mass(0.05));
  EXPECT_EQ(totals[1].particles, 0);
  EXPECT_EQ(totals[5].particles, 1);
  EXPECT_EQ(totals[6].name, "hole");
  EXPECT_EQ(totals[6].particles, 2);
  EXPECT_EQ(totals[8].mass, mass(0.06));
}

// In a periodic direction a particle is where its image in the domain is.
TEST(Exits, NothingLeavesInAPeriodicDirection) {
  Exits e;
  DomainDeck periodic = domain;
  periodic.periodic = {Axis::x};
  e.particles.periodic = Periodicity(periodic);
  e.exits = {{"left_half", DomainFace::z_min, {-1.0, -2.0, 0.0}, {0.0, 2.0, 0.0}}};
  e.add({-1.2, 0.0, 0.0});
  e.add({1.3, 0.0, -3.1});   // its image is at -0.7
  e.add({-1.3, 0.0, -3.1});  // at 0.7
  retire_leavers(e.particles.periodic.open_bounds(periodic), e.exits, e.materials, e.unit, e.particles, e.left);
  EXPECT_EQ(e.left.particles, (std::array<std::int64_t, 6>{0, 0, 0, 0, 2, 0}));
  EXPECT_EQ(e.left.named_particles, std::vector<std::int64_t>{1});
  EXPECT_FALSE(is_parked(e.particles.record[0]));
}

TEST(Exits, LeaversAreParkedOnceAndApart) {
  Exits e;
  for (int n = 0; n < 5; ++n) e.add({0.0, 0.0, -4.0});
  e.retire();
  e.retire();
  EXPECT_EQ(e.left.particles[4], 5);
  for (std::size_t i = 0; i < 5; ++i) {
    const ParticleRecord& p = e.particles.record[i];
    EXPECT_TRUE(is_parked(p));
    EXPECT_EQ(p.velocity, Vec3{});
    EXPECT_EQ(p.spin, Vec3{});
    for (std::size_t j = 0; j < i; ++j) EXPECT_GT(norm(p.position - e.particles.record[j].position), 1e19);
  }
}

TEST(Exits, GhostsAreTheirOwnersBusiness) {
  Exits e;
  e.add({0.0, 0.0, 0.0});
  e.add({5.0, 0.0, 0.0});
  e.particles.owned = 1;
  e.retire();
  EXPECT_EQ(e.left.particles[1], 0);
  EXPECT_FALSE(is_parked(e.particles.record[1]));
}

TEST(MassUnit, SumsToTheTotalWithin62Bits) {
  const double total = 0.0125;
  const MassUnit unit(total);
  EXPECT_LT(unit.count(total), std::int64_t{1} << 61);
  EXPECT_GE(unit.count(total), std::int64_t{1} << 60);
  EXPECT_EQ(unit.kilograms(unit.count(total)), total);
  EXPECT_EQ(unit.count(0.0), 0);
}

}  // namespace
}  // namespace repose::test
