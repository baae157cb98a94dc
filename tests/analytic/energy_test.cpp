// The energy balance of the contact law and the integrator.
#include <cmath>

#include <gtest/gtest.h>

#include "measurement/energies.h"
#include "support/contact_options.h"
#include "support/scenes.h"

namespace repose::test {
namespace {

constexpr double radius = 0.00022;

double total_energy(Scene& scene) {
  const Simulation& s = scene.simulation();
  return measure_energies(s.comm(), s.deck().gravity, s.materials(), s.particles(), s.pairs(), s.walls(),
                          s.wall_contacts())
      .total();
}

struct Drift {
  double of_total = 0.0;  ///< change of the kinetic energy of all grains, over its initial value
  double rms = 0.0;       ///< the same grain by grain, root mean square
};

/// Frictionless elastic grains bouncing between two planes 1 mm apart, each for about 100 collisions. They start at
/// different heights, so that they meet the planes at all phases of a step. Those in contact at the end are left out.
Drift drift_over_100_collisions(double dt) {
  Coefficients c;
  c.restitution_pw = 1.0;
  c.sliding_pw = 0.0;
  c.rolling_pw = 0.0;
  Deck deck = bare_deck(c, dt);
  WallDeck ceiling = floor_at(0.001);
  ceiling.name = "ceiling";
  deck.walls = {floor_at(0.0), ceiling};
  std::vector<Grain> grains;
  for (int k = 0; k < 40; ++k) {
    grains.push_back({{0.001 * k, 0.0, 0.00025 + 1.23456789e-5 * k}, {0.0, 0.0, -0.2}, {}, radius});
  }
  Scene scene(deck, grains);
  scene.run(static_cast<std::int64_t>(0.32 / dt));
  Drift drift;
  int free = 0;
  for (const Grain& grain : scene.grains()) {
    if (grain.position.z < radius || grain.position.z > 0.001 - radius) continue;
    ++free;
    const double change = squared_norm(grain.velocity) / 0.04 - 1.0;
    drift.of_total += change;
    drift.rms += change * change;
  }
  EXPECT_GT(free, 20);
  return {drift.of_total / free, std::sqrt(drift.rms / free)};
}

TEST(Energy, ElasticCollisionsKeepItWithSecondOrderDrift) {
  // A factor of eight between the steps: how contact and step meet modulates the error, by up to a factor of two.
  const Drift coarse = drift_over_100_collisions(4e-6);
  const Drift fine = drift_over_100_collisions(5e-7);
  std::cout << "  of the total " << coarse.of_total << " at 4 us, " << fine.of_total << " at 0.5 us; rms of a grain "
            << coarse.rms << ", " << fine.rms << "\n";
  EXPECT_LT(std::fabs(drift_over_100_collisions(2e-6).of_total), 1e-4);
  EXPECT_LT(std::fabs(fine.of_total), 1e-4);
  EXPECT_LT(fine.rms, coarse.rms / 64.0);
  EXPECT_GT(fine.rms, 0.0);
}

TEST(Energy, NeverGrowsWithFrictionAndLosses) {
  Coefficients c;
  Deck deck = bare_deck(c, 2e-6);
  deck.gravity = {0.0, 0.0, -9.81};
  deck.walls.push_back(floor_at(0.0));
  std::vector<Grain> grains;
  for (int k = 0; k < 60; ++k) {  // a loose tower that collapses
    const double x = 0.5e-3 * (k % 3) + 2e-5 * (k % 7);
    const double y = 0.5e-3 * ((k / 3) % 3) + 1.5e-5 * (k % 5);
    grains.push_back({{x, y, 0.3e-3 + 0.5e-3 * (k / 9)}, {0.02 * ((k % 4) - 1.5), 0.0, 0.0}, {}, radius});
  }
  Scene scene(deck, grains);
  const double initial = total_energy(scene);
  double before = initial;
  for (int sample = 0; sample < 30; ++sample) {
    scene.run(5000);
    const double now = total_energy(scene);
    EXPECT_LT(now, before + 1e-4 * initial) << "after " << 0.01 * (sample + 1) << " s";
    before = now;
  }
  EXPECT_LT(before, 0.5 * initial);  // it did collapse
}

struct ObliqueImpact {
  double change_in_contact = 0.0;  ///< greatest of the total energy, over its initial value
  double change = 0.0;             ///< from before to after
};

bool has_spring(Scene& scene) {
  bool found = false;
  for (const PairGroup& group : scene.simulation().pairs().groups()) {
    for (const ContactBlock& block : group.blocks) {
      for (std::size_t lane = 0; lane < block_lanes; ++lane) found |= norm(history(block, lane).spring) > 0.0;
    }
  }
  return found;
}

/// Two elastic grains that spin meet at an angle and stick until they part.
ObliqueImpact oblique_impact(const Deck& deck) {
  Scene scene(deck, {{{0, 0, 0}, {}, {30, -20, 10}, radius},
                     {{1e-4, 0, 1.45 * radius}, {0.05, 0.02, -0.1}, {-10, 40, 5}, 0.5 * radius}});
  const double initial = total_energy(scene);
  ObliqueImpact impact;
  for (int sample = 0; sample < 2000; ++sample) {
    scene.run(5);
    impact.change = std::fabs(total_energy(scene) / initial - 1.0);
    if (has_spring(scene)) impact.change_in_contact = std::max(impact.change_in_contact, impact.change);
  }
  EXPECT_GT(impact.change_in_contact, 0.0);  // they have met
  return impact;
}

Deck elastic_deck(double rolling_friction) {
  Coefficients c;
  c.restitution_pp = 1.0;
  c.sliding_pp = 1e6;
  c.rolling_pp = rolling_friction;
  return bare_deck(c, 2e-8);
}

TEST(Energy, OfHookesSpringsIsKeptWhileTheyTouch) {
  Deck deck = elastic_deck(1e6);
  const ObliqueImpact hertz = oblique_impact(deck);
  deck = with_hooke(deck);
  const ObliqueImpact fixed = oblique_impact(deck);
  deck.contact.tangential_spring = TangentialSpring::rotated;
  deck.contact.rolling_history = RollingHistory::rotated;
  const ObliqueImpact rotated = oblique_impact(deck);
  std::cout << "  Hertz " << hertz.change_in_contact << ", Hooke " << fixed.change_in_contact << ", rotated "
            << rotated.change_in_contact << "\n";
  EXPECT_GT(hertz.change_in_contact, 0.1);  // k_t and k_r change with the overlap
  EXPECT_LT(fixed.change_in_contact, 2e-3);
  EXPECT_LT(rotated.change_in_contact, 2e-3);
}

// With k_t = 2/7 k_n the tangential spring has the period of the normal one: it is relaxed when the surfaces part.
TEST(Energy, OfHookesSpringsIsGivenBackAtTwoSevenths) {
  Deck deck = with_hooke(elastic_deck(0.0));
  EXPECT_LT(oblique_impact(deck).change, 1e-4);
  deck.pairs[0].hooke_tangential_ratio = 0.5;
  EXPECT_GT(oblique_impact(deck).change, 1e-2);
}

}  // namespace
}  // namespace repose::test
