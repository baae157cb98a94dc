// Walls under load: a grain between two planes by the closed form, a plate of given weight on a bed, the same bits on
// any number of ranks and whatever the lists, a wall that finds nothing.
#include <algorithm>
#include <cmath>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "deck/read_deck.h"
#include "measurement/wall_loads.h"
#include "measurement/wall_resistance.h"
#include "servo_runs.h"
#include "simulation/phases.h"
#include "simulation/simulation.h"
#include "support/glass_beads.h"
#include "support/scenes.h"

namespace repose::test {
namespace {

const std::string plate_on_bed = glass + R"(
[domain]
min = [-0.006, -0.006, -0.002]
max = [0.006, 0.006, 0.03]
)" + glass_tube("tube", 0.03) + R"(
[[wall]]
name = "plate"
type = "disc"
material = "glass"
centre = [0.0, 0.0, 0.013]
radius = 0.0052
[wall.servo]
direction = [0.0, 0.0, -1.0]
force = 0.04
max_speed = 0.2
max_way = 0.012
tolerance = 1e-3
phases = ["press", "rest"]
)" + glass_beads(500, 0.012) + R"(
[[phase]]
name = "fall"
until = "steps"
steps = 6000
[[phase]]
name = "press"
until = "servo"
min_time = "10 ms"
max_time = 0.3
[[phase]]
name = "rest"
until = "steps"
steps = 4000
)";

/// With the forces on the plate along its axis.
ServoOutcome run(const Communicator& comm, const std::vector<std::string>& overrides = {},
                 VectorLevel level = best_vector_level()) {
  return run_servo(comm, plate_on_bed, overrides, level,
                   [](const std::vector<WallLoad>& walls) { return walls[1].force.z; });
}

TEST(Servo, APlateOfGivenWeightComesToRestOnABed) {
  const Communicator world(MPI_COMM_WORLD);
  const ServoOutcome outcome = run(world);
  ASSERT_EQ(outcome.ended_by.size(), 3U);
  EXPECT_EQ(outcome.ended_by[1], "servo");
  for (const double force : outcome.loads) EXPECT_NEAR(force, 0.04, 0.04 * 1e-3);
  for (const double way : outcome.ways) EXPECT_NEAR(way, outcome.ways.front(), 1e-6);  // 1e-3 of a grain
  EXPECT_GT(outcome.ways.front(), 1e-3);
}

TEST(Servo, SameBitsOnAllRanksAsOnOne) { expect_the_bits_of_one_rank(run); }

TEST(Servo, SameBitsWhateverTheListsAndTheVectors) { expect_the_bits_of_other_lists_and_vectors(run); }

/// A grain of 1 mm on a plane at z = 0, without gravity, below a lid that presses along `direction`.
Deck grain_under_lid(const Vec3& direction, double force) {
  Deck deck = bare_deck({}, 1e-6);
  WallDeck lid = floor_at(2.1e-3);
  lid.name = "lid";
  lid.servo.enabled = true;
  lid.servo.direction = direction;
  lid.servo.force = force;
  lid.servo.max_speed = 0.1;
  lid.servo.max_way = 1e-3;
  deck.walls = {floor_at(0.0), lid};
  return deck;
}

TEST(Servo, AGrainBetweenTwoPlanesIsPressedAsHertzSays) {
  for (const double force : {1e-4, 1e-2, 0.3}) {
    Scene scene(grain_under_lid({0.0, 0.0, -1.0}, force), {{{0.0, 0.0, 1e-3}, {}, {}, 1e-3}});
    scene.simulation().begin_phase("any");
    scene.run(60000);
    // F = 4/3 E_eff sqrt(R) delta^(3/2) on either side, E_eff = E / (2 (1 - nu^2))
    const double modulus = 5e6 / (2.0 * (1.0 - 0.09));
    const double overlap = std::pow(0.75 * force / (modulus * std::sqrt(1e-3)), 2.0 / 3.0);
    EXPECT_NEAR(scene.simulation().walls()[1].servo->way(), 1e-4 + 2.0 * overlap, 1e-3 * overlap) << force;
  }
}

// Before the next look the lid could go through a tenth of the radius, five times the overlap that ends a run.
TEST(Servo, IsTriedNoDeeperThanForcesReach) {
  Deck deck = grain_under_lid({0.0, 0.0, -1.0}, 1e-3);
  deck.walls[1].point.z = 2e-3 - 1e-8;  // on the grain
  deck.guards.max_overlap = 0.02;
  Scene scene(deck, {{{0.0, 0.0, 1e-3}, {}, {}, 1e-3}});
  const Simulation& s = scene.simulation();
  const double speed = s.walls()[1].servo->max_speed();
  const WallResistance grains =
      measure_resistance(Communicator(MPI_COMM_WORLD), s.vector_level(), {1, 1e-4 / speed, 0.02}, s.walls(),
                         s.materials(), s.particles(), s.wall_contacts());
  const double modulus = 5e6 / (2.0 * (1.0 - 0.09));
  const double hertz = 4.0 / 3.0 * modulus * std::sqrt(1e-3) * std::pow(0.04e-3, 1.5);
  EXPECT_GT(grains.per_speed * speed, hertz);
  EXPECT_LT(grains.per_speed * speed, 1.5 * hertz);  // with the dashpot
}

/// Six layers of a face-centred crystal between two planes, without friction and gravity; 1.414496 mm is just above
/// sqrt(2) mm, so that grains beside each other do not touch.
const char* const crystal = R"(
gravity = [0.0, 0.0, 0.0]
[domain]
min = [0.0, 0.0, -0.001]
max = [0.005657984, 0.005657984, 0.01]
periodic = ["x", "y"]
[[material]]
name = "grain"
youngs_modulus = 5e7
poisson_ratio = 0.25
density = 2500.0
[[pair]]
materials = ["grain", "grain"]
restitution = 0.3
sliding_friction = 0.0
rolling_friction = 0.0
[[wall]]
name = "floor"
type = "plane"
material = "grain"
point = [0.0, 0.0, 0.0]
[[wall]]
name = "lid"
type = "plane"
material = "grain"
point = [0.0, 0.0, 0.00456]
[wall.servo]
direction = [0.0, 0.0, -1.0]
force = 1.0
max_speed = 0.05
max_way = 0.001
[[particles]]
type = "lattice"
material = "grain"
diameter = 0.001
lattice = "face_centred"
counts = [4, 4, 3]
spacing = 0.001414496
first = [0.0003, 0.0003, 0.0005]
[time]
step = 1e-6
[[phase]]
name = "press"
until = "servo"
max_time = 1.0
)";

/// m, by which the lid has to come down for `force` N on each grain of a layer: two contacts with planes, and five
/// layers that come nearer, each grain resting on four.
double crystal_way(double force) {
  const double modulus = 5e7 / (2.0 * (1.0 - 0.0625));
  const double overlap_at_wall = std::pow(0.75 * force / (modulus * std::sqrt(0.5e-3)), 2.0 / 3.0);
  const double half = 0.5 * 0.001414496;
  double low = 0.8 * half, high = half;
  for (int k = 0; k < 100; ++k) {  // the distance of two layers
    const double between = 0.5 * (low + high);
    const double apart = std::sqrt(half * half + between * between);
    const double overlap = std::max(0.0, 1e-3 - apart);
    const double borne = 4.0 * (4.0 / 3.0) * modulus * std::sqrt(0.25e-3) * std::pow(overlap, 1.5) * between / apart;
    (borne > force ? low : high) = between;
  }
  return 0.00456 - (1e-3 - 2.0 * overlap_at_wall + 5.0 * high);
}

TEST(Servo, ACrystalStiffensWithTheThirdRootOfTheStress) {
  const Communicator world(MPI_COMM_WORLD);
  const auto way_of = [&](double force) {  // on all 32 grains of a layer
    const Deck deck = read_deck(crystal, "crystal.toml",
                                {fmt::format("wall.lid.servo.force={}", force), "wall.lid.servo.tolerance=1e-6"});
    Simulation s(world, deck, {}, best_vector_level());
    const Phase phase(deck.phases[0], s);
    while (!phase.ended_by(s, 100)) s.advance(100);
    EXPECT_EQ(*phase.ended_by(s, 100), "servo");
    return s.walls()[1].servo->way();
  };
  const auto stiffness = [&](double force) { return 0.02 * force / (way_of(1.01 * force) - way_of(0.99 * force)); };
  for (const double force : {0.01, 0.32}) {
    EXPECT_NEAR(way_of(force) / crystal_way(force / 32.0), 1.0, 1e-4) << force;
  }
  EXPECT_NEAR(std::log(stiffness(0.32) / stiffness(0.01)) / std::log(32.0), 1.0 / 3.0, 0.005);
}

TEST(Servo, AWallThatFindsNothingSaysSoOnce) {
  Scene scene(grain_under_lid({0.0, 0.0, 1.0}, 0.01), {{{0.0, 0.0, 1e-3}, {}, {}, 1e-3}});
  Simulation& s = scene.simulation();
  s.begin_phase("any");
  std::vector<std::string> told;
  for (int k = 0; k < 30000; k += 7) {  // not in step with the looks
    s.advance(7);
    if (const auto warning = s.take_warning()) told.push_back(*warning);
  }
  ASSERT_EQ(told.size(), 1U);
  EXPECT_NE(told[0].find("wall \"lid\": its servo has come to max_way = 0.001 m"), std::string::npos) << told[0];
  EXPECT_NE(told[0].find("no resistance"), std::string::npos) << told[0];
  EXPECT_EQ(s.walls()[1].servo->way(), 1e-3);
}

TEST(Servo, APhaseEndsOnceTheForceOnAWallIsReached) {
  Deck deck = grain_under_lid({0.0, 0.0, -1.0}, 0.02);
  PhaseDeck press;
  press.name = "press";
  press.until = PhaseUntil::wall_force;
  press.wall = "floor";
  press.force = 0.01;
  press.max_time = 1.0;
  deck.phases = {press};
  Scene scene(deck, {{{0.0, 0.0, 1e-3}, {}, {}, 1e-3}});
  Simulation& s = scene.simulation();
  const Phase phase(deck.phases[0], s);
  std::optional<std::string> ended;
  while (!(ended = phase.ended_by(s, 10))) s.advance(10);
  EXPECT_EQ(*ended, "wall_force");
  const Communicator world(MPI_COMM_WORLD);
  const double force = norm(
      measure_wall_loads(world, s.vector_level(), s.walls(), s.materials(), s.particles(), s.wall_contacts())[0].force);
  EXPECT_GT(force, 0.01);
  EXPECT_LT(force, 0.021);
}

}  // namespace
}  // namespace repose::test
