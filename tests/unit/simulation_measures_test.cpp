// Energies, contact counts and masses of small scenes, and what is said of a guard that was hit.
#include <cmath>

#include <gtest/gtest.h>

#include "domain/exits.h"
#include "measurement/discharged_mass.h"
#include "measurement/energies.h"
#include "scene/particles/sphere_mass.h"
#include "support/scenes.h"

namespace repose::test {
namespace {

constexpr double radius = 1e-3;
constexpr double density = 3592.0;

Energies energies_of(const Simulation& s) {
  return measure_energies(s.comm(), s.deck().gravity, s.materials(), s.particles(), s.pairs(), s.walls(),
                          s.wall_contacts());
}

TEST(Energies, ByHand) {
  Deck deck = bare_deck({}, 1e-6);
  deck.gravity = {0.0, 0.0, -10.0};
  deck.walls.push_back(floor_at(0.0));
  const double overlap = 1e-5;
  // Two that overlap, one of them in the floor, and one in flight; nothing has moved yet, so no tangential springs.
  Scene scene(deck, {{{0.0, 0.0, radius - overlap}, {}, {}, radius},
                     {{0.0, 0.0, 4.0 * radius - 2.0 * overlap}, {0.0, 0.1, 0.0}, {}, 2.0 * radius},
                     {{0.1, 0.0, 0.2}, {0.0, 0.0, -0.2}, {30.0, 0.0, 40.0}, radius}});
  const Simulation& s = scene.simulation();
  const double m = sphere_mass(radius, density);
  const double e_pair = s.materials().pair(0, 0).youngs_modulus_eff;
  const double e_wall = s.materials().pair(0, 1).youngs_modulus_eff;
  // The work of Hertz's force, 8/15 E_eff sqrt(R_eff) d^5/2; R_eff = 2/3 mm in the pair, 1 mm at the wall.
  const double elastic =
      8.0 / 15.0 * std::pow(overlap, 2.5) * (e_pair * std::sqrt(2.0 / 3.0 * radius) + e_wall * std::sqrt(radius));
  const Energies e = energies_of(s);
  EXPECT_NEAR(e.translational, 0.5 * 8.0 * m * 0.01 + 0.5 * m * 0.04, 1e-20);
  EXPECT_NEAR(e.rotational, 0.5 * 0.4 * m * radius * radius * 2500.0, 1e-24);
  EXPECT_NEAR(e.gravitational, m * 10.0 * (radius - overlap + 8.0 * (4.0 * radius - 2.0 * overlap) + 0.2), 1e-19);
  EXPECT_NEAR(e.elastic, elastic, 1e-12 * elastic);  // the overlaps are differences: 1e-18 m of 1e-5 m
  EXPECT_NEAR(e.total(), e.translational + e.rotational + e.gravitational + e.elastic, 1e-20);
  EXPECT_NEAR(mean_kinetic_energy(s.comm(), s.materials(), s.particles()), e.translational / 3.0, 1e-21);
  const ContactCount contacts = count_contacts(s.comm(), s.particles(), s.pairs(), s.walls(), s.wall_contacts());
  EXPECT_EQ(contacts.pairs, 1);
  EXPECT_EQ(contacts.walls, 1);
}

// One step of 1e-6 s at 1 mm/s sideways stretches the spring by 1e-9 m and, spinning, loads the rolling moment.
TEST(Energies, SpringsHoldTheirShare) {
  Scene scene(bare_deck({}, 1e-6), {{{0.0, 0.0, 0.0}, {}, {}, radius},
                                    {{0.0, 0.0, 1.99 * radius}, {1e-3, 0.0, 0.0}, {0.0, 0.0, 0.0}, radius}});
  scene.run(1);
  const Simulation& s = scene.simulation();
  ASSERT_EQ(s.pairs().lanes(), 1U);
  ContactHistory history = {};
  for (const PairGroup& group : s.pairs().groups()) {
    if (group.lanes > 0) history = lane_history(group, 0);
  }
  EXPECT_NEAR(history.spring.x, -1e-9, 1e-11);  // of the first relative to the second; friction has braked half a step
  const ParticleRecord& a = s.particles().record[0];
  const ParticleRecord& b = s.particles().record[1];
  const double overlap = a.radius + b.radius - norm(a.position - b.position);
  const double contact_radius = std::sqrt(0.5 * radius * overlap);
  const double k_n = 4.0 / 3.0 * s.materials().pair(0, 0).youngs_modulus_eff * contact_radius;
  const double k_t = 8.0 * s.materials().pair(0, 0).shear_modulus_eff * contact_radius;
  const double expected = 0.4 * k_n * overlap * overlap + 0.5 * k_t * squared_norm(history.spring) +
                          0.5 * squared_norm(history.rolling) / (k_t * 0.25 * radius * radius);
  EXPECT_NEAR(energies_of(s).elastic, expected, 1e-13 * expected);
}

TEST(Energies, WithoutParticlesInTheDomainAreZero) {
  Deck deck = bare_deck({}, 1e-5);
  deck.domain = {{-0.01, -0.01, -0.01}, {0.01, 0.01, 0.01}};
  Scene scene(deck, {{{}, {1.0, 0.0, 0.0}, {}, radius}});
  scene.run(1200);
  const Simulation& s = scene.simulation();
  EXPECT_EQ(sum_of(s.comm(), s.left_here()).particles[1], 1);
  EXPECT_EQ(energies_of(s).total(), 0.0);
  EXPECT_EQ(mean_kinetic_energy(s.comm(), s.materials(), s.particles()), 0.0);
}

TEST(DischargedMass, CountsBelowTheOrificeAndAllExitsButTheTop) {
  const Communicator comm(MPI_COMM_SELF);
  const MaterialTable materials(bare_deck({}, 1e-6));
  Particles p;
  for (const double z : {-2.0, -1.0, -0.5, 0.5}) {
    p.record.push_back({{0.0, 0.0, z}, radius, {}, 1.0, {}, 1.0});
    p.id.push_back(static_cast<std::int64_t>(p.owned++));
    p.material.push_back(0);
  }
  park(p.record[0], 0);
  const double mass = sphere_mass(radius, density);
  const MassUnit unit(10.0 * mass);
  ExitCount left;
  for (std::size_t face = 0; face < 6; ++face) left.mass[face] = unit.count(static_cast<double>(1U << face) * mass);
  const double tolerance = 10.0 * unit.kilograms(1);
  // Below -0.5: the one at -1 alone. By the exits but the top: 1 + 2 + 4 + 8 + 16.
  EXPECT_NEAR(discharged_mass(comm, -0.5, materials, unit, p, left), (1.0 + 31.0) * mass, tolerance);
  EXPECT_NEAR(discharged_mass(comm, 1.0, materials, unit, p, left), (3.0 + 31.0) * mass, tolerance);
  EXPECT_NEAR(total_mass(comm, materials, unit, p, left), (3.0 + 31.0) * mass, tolerance);
}

}  // namespace
}  // namespace repose::test
