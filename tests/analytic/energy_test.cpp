// The energy balance of the contact law and the integrator.
#include <gtest/gtest.h>

#include <cmath>

#include "measurement/energies.h"
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
  double greatest = 0.0;  ///< over the initial energy
  int collisions = 0;
};

/// A frictionless elastic grain between two planes, for 100 collisions.
Drift drift_over_100_collisions(double dt) {
  Coefficients c;
  c.restitution_pw = 1.0;
  c.sliding_pw = 0.0;
  c.rolling_pw = 0.0;
  Deck deck = bare_deck(c, dt);
  WallDeck ceiling = floor_at(0.001);
  ceiling.name = "ceiling";
  deck.walls = {floor_at(0.0), ceiling};
  Scene scene(deck, {{{0.0, 0.0, 0.0005}, {0.0, 0.0, -0.2}, {}, radius}});
  const double initial = total_energy(scene);
  Drift drift;
  bool touching = false;
  while (drift.collisions < 100) {
    scene.run(1);
    const bool touches = !scene.simulation().wall_contacts().contacts().empty();
    drift.collisions += touching && !touches ? 1 : 0;
    touching = touches;
    drift.greatest = std::max(drift.greatest, std::fabs(total_energy(scene) - initial) / initial);
  }
  return drift;
}

TEST(Energy, ElasticCollisionsKeepItWithSecondOrderDrift) {
  const Drift coarse = drift_over_100_collisions(2e-6);
  const Drift fine = drift_over_100_collisions(1e-6);
  EXPECT_LT(coarse.greatest, 1e-4);
  EXPECT_LT(fine.greatest, coarse.greatest / 3.0);
  EXPECT_GT(fine.greatest, 0.0);
  std::cout << "  drift " << coarse.greatest << " at 2 us, " << fine.greatest << " at 1 us\n";
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

}  // namespace
}  // namespace repose::test
