// Liquid bridges: they form on contact, pull by their law, and break.
#include <cmath>

#include <gtest/gtest.h>

#include "base/math.h"
#include "support/scenes.h"

namespace repose::test {
namespace {

constexpr double radius = 2.2e-4;
constexpr double surface_tension = 0.07;  // N/m
constexpr double volume = 1e-15;          // m3: a cube of 10 um
constexpr double speed = 0.1;
constexpr double timestep = 1e-8;

/// Grains too heavy for forces to move; the pull of a bridge is 2 pi R gamma cos(theta), and twice that at a wall.
Deck wet_deck() {
  Coefficients c;
  c.density = 1e13;
  c.restitution_pp = c.restitution_pw = 1.0;
  Deck deck = bare_deck(c, timestep);
  deck.contact.cohesion = Cohesion::capillary;
  for (PairDeck& pair : deck.pairs) {
    pair.surface_tension = surface_tension;
    pair.contact_angle = 60.0;
    pair.bridge_volume = volume;
  }
  return deck;
}

const double breaking_distance = (1.0 + pi / 6.0) * 1e-5;

double force_on(Scene& scene, std::size_t i) {
  const Particles& p = scene.simulation().particles();
  return static_cast<double>(p.sum[i].force[2]) / p.record[i].force_scale;
}

/// The force on grain `i`, drawn away at `speed` from an overlap of one step, against the law.
void expect_bridge(Scene& scene, std::size_t i, double pull) {
  scene.run(1);  // at an overlap of 0 but for rounding, where it is attached
  for (int step = 2; step < 20000; ++step) {
    scene.run(1);
    const double gap = speed * timestep * (step - 1.5);
    if (std::fabs(gap - breaking_distance) < 2.0 * speed * timestep) continue;  // the step at which it breaks
    const double expected = gap < breaking_distance ? -pull * (1.0 - gap / breaking_distance) : 0.0;
    ASSERT_NEAR(force_on(scene, i), expected, 1e-6 * pull) << step;  // rounding of the distance over the bridge
  }
}

TEST(Capillary, PullsLinearlyUntilItBreaks) {
  const double overlap = 1.5 * speed * timestep;
  Scene scene(wet_deck(), {{{0, 0, 0}, {}, {}, radius}, {{0, 0, 2.0 * radius - overlap}, {0, 0, speed}, {}, radius}});
  expect_bridge(scene, 1, 2.0 * pi * radius * surface_tension * 0.5);
}

TEST(Capillary, PullsTwiceAsMuchAtAWall) {
  Deck deck = wet_deck();
  deck.walls.push_back(floor_at(0.0));
  Scene scene(deck, {{{0, 0, radius - 1.5 * speed * timestep}, {0, 0, speed}, {}, radius}});
  expect_bridge(scene, 0, 4.0 * pi * radius * surface_tension * 0.5);
}

TEST(Capillary, ABridgeFormsOnContactAlone) {
  Scene scene(wet_deck(), {{{0, 0, 0}, {}, {}, radius}, {{0, 0, 2.0 * radius + 1e-7}, {}, {}, radius}});
  scene.run(10);
  EXPECT_EQ(force_on(scene, 1), 0.0);
}

TEST(Capillary, RefusesBridgesThatAreTooLong) {
  Deck deck = wet_deck();
  for (PairDeck& pair : deck.pairs) pair.bridge_volume = 1e-12;
  try {
    Scene scene(deck, {{{0, 0, 0}, {}, {}, radius}});
    FAIL();
  } catch (const std::exception& error) {
    EXPECT_NE(std::string(error.what()).find("give them a smaller bridge_volume"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace repose::test
