// When phases end, and what they do to the walls.
#include <gtest/gtest.h>

#include "simulation/phases.h"
#include "support/scenes.h"

namespace repose::test {
namespace {

PhaseDeck until(PhaseUntil condition) {
  PhaseDeck deck;
  deck.name = "phase";
  deck.until = condition;
  return deck;
}

TEST(Steps, CoverATimeToTheNearest) {
  EXPECT_EQ(steps_for(1.0, 0.25), 4);
  EXPECT_EQ(steps_for(1.1, 5e-6), 220000);
  EXPECT_EQ(steps_for(1.1, 0.25), 4);
  EXPECT_EQ(steps_for(1.2, 0.25), 5);
  EXPECT_EQ(steps_for(0.0, 0.25), 0);
}

TEST(Steps, LongestIsTheLeastOfAllBounds) {
  PhaseDeck deck = until(PhaseUntil::time);
  deck.time = 2.0;
  EXPECT_EQ(longest_steps(deck, 0.5), 4);
  deck.max_time = 1.5;
  EXPECT_EQ(longest_steps(deck, 0.5), 3);
  deck = until(PhaseUntil::steps);
  deck.steps = 7;
  EXPECT_EQ(longest_steps(deck, 0.5), 7);
  deck.max_time = 1.5;
  EXPECT_EQ(longest_steps(deck, 0.5), 3);
  deck = until(PhaseUntil::kinetic_energy);
  deck.max_time = 1.5;
  EXPECT_EQ(longest_steps(deck, 0.5), 3);
}

constexpr double dt = 1e-5;

Scene flying_grain(double speed) { return {bare_deck({}, dt), {{{}, {0.0, speed, 0.0}, {}, 1e-3}}}; }

struct Ending {
  std::int64_t steps = 0;
  std::string by;
};

Ending run_phase(Scene& scene, const PhaseDeck& deck, std::int64_t check_every = 10) {
  const Phase phase(deck, scene.simulation());
  for (int step = 0; step < 1000; ++step) {
    if (const auto end = phase.ended_by(scene.simulation(), check_every)) {
      return {phase.steps_done(scene.simulation()), *end};
    }
    scene.run(1);
  }
  return {};
}

TEST(Phase, EndsByItsTimeOrItsSteps) {
  Scene scene = flying_grain(1.0);
  scene.run(3);  // a phase counts from its own start
  PhaseDeck deck = until(PhaseUntil::time);
  deck.time = 37 * dt;
  Ending end = run_phase(scene, deck);
  EXPECT_EQ(end.steps, 37);
  EXPECT_EQ(end.by, "time");
  deck = until(PhaseUntil::steps);
  deck.steps = 21;
  end = run_phase(scene, deck);
  EXPECT_EQ(end.steps, 21);
  EXPECT_EQ(end.by, "steps");
  EXPECT_EQ(scene.simulation().steps(), 61);
}

TEST(Phase, EndsByMaxTimeWhateverItsCondition) {
  for (const PhaseUntil condition : {PhaseUntil::time, PhaseUntil::steps, PhaseUntil::kinetic_energy}) {
    Scene scene = flying_grain(1.0);
    PhaseDeck deck = until(condition);
    deck.time = 1.0;
    deck.steps = 100000;
    deck.kinetic_energy = 1e-13;
    deck.max_time = 25 * dt;
    const Ending end = run_phase(scene, deck);
    EXPECT_EQ(end.steps, 25);
    EXPECT_EQ(end.by, "max_time");
  }
}

// One grain: 0.5 x 3592 x 4/3 pi 1e-9 kg x 1 m2/s2 = 7.52e-6 J.
TEST(Phase, EndsBelowItsEnergyAtTheNextLookAfterItsMinTime) {
  PhaseDeck deck = until(PhaseUntil::kinetic_energy);
  deck.min_time = 33 * dt;
  deck.max_time = 500 * dt;
  Scene scene = flying_grain(1.0);
  deck.kinetic_energy = 7.53e-6;
  Ending end = run_phase(scene, deck);
  EXPECT_EQ(end.steps, 40);
  EXPECT_EQ(end.by, "kinetic_energy");
  deck.kinetic_energy = 7.51e-6;
  end = run_phase(scene, deck);
  EXPECT_EQ(end.steps, 500);
  EXPECT_EQ(end.by, "max_time");
}

bool present(const Simulation& simulation, const std::string& name) {
  for (const Wall& wall : simulation.walls()) {
    if (wall.name == name) return wall.present;
  }
  ADD_FAILURE() << "no wall " << name;
  return false;
}

TEST(Phase, AddsAndRemovesWallsAtItsStart) {
  Deck deck = bare_deck({}, dt);
  deck.gravity = {0.0, 0.0, -9.81};
  deck.walls = {floor_at(0.0), floor_at(-1e-3)};
  deck.walls[1].name = "cellar";
  deck.walls[1].present = false;
  Scene scene(deck, {{{0.0, 0.0, 1e-3}, {}, {}, 1e-3}});
  scene.run(2000);
  EXPECT_NEAR(scene.grains()[0].position.z, 1e-3, 1e-5);  // it rests on the floor
  PhaseDeck change = until(PhaseUntil::steps);
  change.steps = 4000;
  change.remove_walls = {"floor"};
  change.add_walls = {"cellar"};
  run_phase(scene, change);
  EXPECT_FALSE(present(scene.simulation(), "floor"));
  EXPECT_TRUE(present(scene.simulation(), "cellar"));
  scene.run(10000);
  EXPECT_NEAR(scene.grains()[0].position.z, 0.0, 1e-5);  // on the one below
}

}  // namespace
}  // namespace repose::test
