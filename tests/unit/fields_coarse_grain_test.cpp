#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "fields/coarse_grain.h"

namespace repose::fields {
namespace {

constexpr double g = 9.81;

/// Cells of `spacing` that fill the cube from 0 to `length`, periodic in x and y, and in z when asked.
Grid cube(double length, double spacing, bool all) {
  const auto cells = static_cast<std::size_t>(std::rint(length / spacing));
  return {.origin = {},
          .spacing = {spacing, spacing, spacing},
          .cells = {cells, cells, cells},
          .periodic = {true, true, all}};
}

std::vector<Grain> gas(std::size_t count, double length, const Vec3& drift) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(0.0, length);
  std::normal_distribution<double> speed(0.0, 1.0);
  std::uniform_real_distribution<double> size(0.5, 2.0);
  std::vector<Grain> grains;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 centre{place(random), place(random), place(random)};
    const Vec3 velocity{speed(random), 2.0 * speed(random), 3.0 * speed(random)};
    const double volume = size(random);
    grains.push_back({centre, velocity + drift, 2.5 * volume, volume});
  }
  return grains;
}

/// Contacts between neighbours of a list: no bed, but forces and branches in all directions.
ContactForces contacts_of(const std::vector<Grain>& grains) {
  ContactForces contacts;
  for (std::size_t i = 1; i < grains.size(); ++i) {
    const Vec3 branch = grains[i].velocity;
    contacts.pairs.push_back({grains[i].centre, grains[i].centre + branch, grains[i - 1].velocity});
    contacts.walls.push_back({grains[i].centre, grains[i].centre - 0.5 * branch, grains[i - 1].velocity});
  }
  return contacts;
}

template <class T, class Of>
auto sum(const std::vector<T>& values, const Of& of) {
  decltype(of(values[0])) total{};
  for (const T& value : values) total += of(value);
  return total;
}

TEST(Fields, IntegrateToMassVolumeMomentumAndForceTimesBranch) {
  const std::vector<Grain> grains = gas(300, 10.0, {1.0, 2.0, 3.0});
  const ContactForces contacts = contacts_of(grains);
  for (const double width : {0.3, 2.0, 17.0}) {  // narrower than a cell, and wider than the domain
    const Fields f = coarse_grain(cube(10.0, 1.0, true), width, grains, contacts);
    const double mass = sum(grains, [](const Grain& x) { return x.mass; });
    EXPECT_NEAR(sum(f.mass_density, [](double x) { return x; }), mass, 1e-13 * mass);
    EXPECT_NEAR(sum(f.solid_fraction, [](double x) { return x; }), mass / 2.5, 1e-13 * mass);
    const Vec3 momentum = sum(grains, [](const Grain& x) { return x.mass * x.velocity; });
    EXPECT_LT(norm(sum(f.momentum, [](const Vec3& x) { return x; }) - momentum), 1e-13 * norm(momentum));
    for (std::size_t k = 0; k < 9; ++k) {
      double product = 0.0;
      for (const auto* list : {&contacts.pairs, &contacts.walls}) {
        for (const ContactForce& c : *list) product += triple(c.force)[k / 3] * triple(c.centre - c.other)[k % 3];
      }
      EXPECT_NEAR(sum(f.contact_stress, [&](const Tensor& s) { return s[k]; }), product,
                  1e-10);  // of 600 up to 50 each
    }
    const Vec3 force = sum(contacts.walls, [](const ContactForce& c) { return c.force; });
    EXPECT_LT(norm(sum(f.wall_force, [](const Vec3& x) { return x; }) - force), 1e-11);
  }
}

/// Spheres in a cubic lattice, each on the one below, on a floor at half a lattice constant below the lowest layer.
struct Columns {
  static constexpr std::size_t layers = 12, across = 4;
  static constexpr double constant = 0.5, mass = 2.0, floor = 3.0 * constant;
  std::vector<Grain> grains;
  ContactForces contacts;

  Columns() {
    for (std::size_t i = 0; i < across * across * layers; ++i) {
      const std::size_t layer = i / (across * across);
      const Vec3 centre{(static_cast<double>(i % across) + 0.3) * constant,
                        (static_cast<double>(i / across % across) + 0.3) * constant,
                        floor + (static_cast<double>(layer) + 0.5) * constant};
      grains.push_back({centre, {}, mass, 0.05});
      const double weight = g * mass * static_cast<double>(layers - layer);
      const Vec3 below = centre - Vec3{0.0, 0.0, layer == 0 ? 0.5 * constant : constant};
      (layer == 0 ? contacts.walls : contacts.pairs).push_back({centre, below, {0.0, 0.0, weight}});
    }
  }
};

TEST(Fields, OfALatticeUnderGravityHaveTheLithostaticStress) {
  const Columns c;
  constexpr double width = 2.0 * Columns::constant;  // knots at the layers: what repeats with them leaves no ripple
  const Grid grid = {.origin = {}, .spacing = {0.25, 0.25, 0.2}, .cells = {8, 8, 50}, .periodic = {true, true, false}};
  const Fields f = coarse_grain(grid, width, c.grains, c.contacts);
  const double density = Columns::mass / std::pow(Columns::constant, 3);
  const double top = Columns::floor + Columns::layers * Columns::constant;
  const double greatest = density * g * (top - Columns::floor);
  int cells = 0;
  for (std::size_t cell = 0; cell < grid.size(); ++cell) {
    const double z = (static_cast<double>(cell / 64) + 0.5) * 0.2;
    if (z < Columns::floor + 0.5 * Columns::constant + width + 0.1 || z > top - width - 0.35) continue;
    ++cells;
    EXPECT_NEAR(f.mass_density[cell], density, 1e-13 * density);
    EXPECT_NEAR(f.solid_fraction[cell], 0.05 / std::pow(Columns::constant, 3), 1e-14);
    for (std::size_t k = 0; k < 8; ++k) EXPECT_EQ(f.contact_stress[cell][k], 0.0);
    EXPECT_NEAR(f.contact_stress[cell][8], density * g * (top - z), 1e-5 * greatest);  // Deposit::along
    EXPECT_EQ(f.wall_force[cell], Vec3{});
  }
  EXPECT_GT(cells, 64 * 10);
}

TEST(Fields, OfABedOnAFloorBalanceItsWeight) {
  const Columns c;
  const Grid grid = {.origin = {}, .spacing = {0.25, 0.25, 0.1}, .cells = {8, 8, 100}, .periodic = {true, true, false}};
  const Fields f = coarse_grain(grid, 1.3, c.grains, c.contacts);
  const double volume = grid.cell_volume();
  const double weight = g * Columns::mass * static_cast<double>(c.grains.size());
  EXPECT_NEAR(volume * sum(f.wall_force, [](const Vec3& x) { return x.z; }), weight, 1e-12 * weight);
  // Clausius: the integral of the stress is the sum of weight times height over the floor.
  const double moment = sum(c.grains, [](const Grain& x) { return g * x.mass * (x.centre.z - Columns::floor); });
  EXPECT_NEAR(volume * sum(f.contact_stress, [](const Tensor& s) { return s[8]; }), moment, 1e-12 * moment);
  // What the stress lets through a level carries what is above it: d/dz of the mean over x and y is the weight less the
  // floor's force, taken here by differences of the means of cells (Simpson: error 1e-3 of the greatest load).
  std::vector<double> stress(100), load(100);
  for (std::size_t cell = 0; cell < grid.size(); ++cell) {
    stress[cell / 64] += f.contact_stress[cell][8] / 64.0;
    load[cell / 64] += (f.wall_force[cell].z - g * f.mass_density[cell]) / 64.0;
  }
  for (std::size_t k = 1; k + 1 < 100; ++k) {
    const double over_three = (load[k - 1] + 4.0 * load[k] + load[k + 1]) / 6.0;  // Simpson's rule
    const double difference = (stress[k + 1] - stress[k - 1]) / 0.2;
    EXPECT_NEAR(difference, over_three, 2e-3 * g * Columns::mass / std::pow(Columns::constant, 3)) << k;
  }
}

TEST(Fields, OfOneContactAreThoseOfItsParts) {
  const Grid grid = cube(4.0, 0.25, false);
  const ContactForce contact{{1.4, 2.2, 1.7}, {2.3, 1.9, 2.4}, {1.0, 0.0, 0.0}};
  for (const double width : {0.6, 1.0, 1.9}) {
    ContactForces parts;
    constexpr int count = 64;
    for (int k = 0; k < count; ++k) {
      const auto at = [&](int n) { return contact.other + (n / double{count}) * (contact.centre - contact.other); };
      parts.pairs.push_back({at(k + 1), at(k), contact.force});
    }
    const Fields whole = coarse_grain(grid, width, {}, {{contact}, {}});
    const Fields sum_of_parts = coarse_grain(grid, width, {}, parts);
    double greatest = 0.0, error = 0.0;
    for (std::size_t cell = 0; cell < grid.size(); ++cell) {
      greatest = std::max(greatest, std::fabs(sum_of_parts.contact_stress[cell][0]));
      error = std::max(error, std::fabs(whole.contact_stress[cell][0] - sum_of_parts.contact_stress[cell][0]));
    }
    EXPECT_LT(error, 1e-5 * greatest) << width;
  }
}

TEST(Fields, OfAMovingGasHaveItsKineticStressWhateverItsDrift) {
  const std::vector<Grain> slow = gas(4000, 10.0, {});
  const Vec3 drift{30.0, -20.0, 10.0};
  const Fields f = coarse_grain(cube(10.0, 10.0, true), 1.0, slow, {});  // a single cell
  const Fields moving = coarse_grain(cube(10.0, 10.0, true), 1.0, gas(4000, 10.0, drift), {});
  const double mass = sum(slow, [](const Grain& x) { return x.mass; });
  const Vec3 mean = (1.0 / mass) * sum(slow, [](const Grain& x) { return x.mass * x.velocity; });
  double trace = 0.0;
  for (std::size_t k = 0; k < 9; ++k) {
    const double stress = sum(slow, [&](const Grain& x) {
      return x.mass * triple(x.velocity - mean)[k / 3] * triple(x.velocity - mean)[k % 3] / 1000.0;
    });
    EXPECT_NEAR(f.kinetic_stress[0][k], stress, 1e-12 * mass / 1000.0) << k;
    EXPECT_NEAR(moving.kinetic_stress[0][k], stress, 1e-11 * mass / 1000.0) << k;
    trace += k % 4 == 0 ? stress : 0.0;
  }
  EXPECT_NEAR(f.temperature[0], trace / (3.0 * mass / 1000.0), 1e-12);
  EXPECT_NEAR(f.temperature[0], 14.0 / 3.0, 0.2);  // 1, 4 and 9 m2/s2 sampled 4000 times: standard error about 0.1
  EXPECT_LT(norm(moving.velocity[0] - f.velocity[0] - drift), 1e-12);
}

TEST(Fields, AreTheSameInAnyOrder) {
  std::vector<Grain> grains = gas(200, 10.0, {});
  ContactForces contacts = contacts_of(grains);
  const Fields f = coarse_grain(cube(10.0, 0.5, false), 1.4, grains, contacts);
  std::mt19937 random(3);
  std::shuffle(grains.begin(), grains.end(), random);
  std::shuffle(contacts.pairs.begin(), contacts.pairs.end(), random);
  std::shuffle(contacts.walls.begin(), contacts.walls.end(), random);
  for (ContactForce& c : contacts.pairs) c = {c.other, c.centre, -c.force};
  const Fields other = coarse_grain(cube(10.0, 0.5, false), 1.4, grains, contacts);
  EXPECT_EQ(f.mass_density, other.mass_density);
  EXPECT_EQ(f.momentum, other.momentum);
  EXPECT_EQ(f.kinetic_stress, other.kinetic_stress);
  EXPECT_EQ(f.contact_stress, other.contact_stress);
  EXPECT_EQ(f.wall_force, other.wall_force);
}

}  // namespace
}  // namespace repose::fields
