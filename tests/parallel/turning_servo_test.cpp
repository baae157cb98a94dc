// Walls that turn against a torque: grains between a vane and two planes by the closed form, a vane of two blades held
// in a bed, the same bits on any number of ranks and whatever the lists and the vectors, phases that end on a torque.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "deck/read_deck.h"
#include "measurement/wall_loads.h"
#include "servo_runs.h"
#include "simulation/phases.h"
#include "simulation/simulation.h"
#include "support/glass_beads.h"
#include "support/scenes.h"

namespace repose::test {
namespace {

constexpr double radius = 1e-3;  // m, of a grain
constexpr double lever = 0.02;   // m, of its centre about the axis
constexpr double plane = 2e-3;   // m, of the planes on both sides of the vane

WallDeck upright_plane(const std::string& name, double x) {
  WallDeck wall = floor_at(0.0);
  wall.name = name;
  wall.point = {x, 0.0, 0.0};
  wall.normal = {1.0, 0.0, 0.0};
  return wall;
}

/// A vane that turns about z, without gravity, between two planes; it pushes a grain to the plane on either side.
Deck grains_beside_vane(double torque) {
  Deck deck = bare_deck({.rolling_pw = 0.0}, 1e-6);  // rolling friction would add to the torque
  deck.domain = {{-0.03, -0.03, -0.03}, {0.03, 0.03, 0.03}};
  WallDeck vane;
  vane.name = "vane";
  vane.type = WallType::rectangle;
  vane.material = "wall";
  vane.corner = {0.0, -0.025, -0.005};
  vane.edge_u = {0.0, 0.05, 0.0};
  vane.edge_v = {0.0, 0.0, 0.01};
  vane.servo.enabled = true;
  vane.servo.type = ServoType::rotation;
  vane.servo.axis_direction = {0.0, 0.0, 2.0};
  vane.servo.torque = torque;
  vane.servo.max_angular_velocity = 5.0;
  vane.servo.max_angle = 10.0;
  deck.walls = {upright_plane("left", -plane), upright_plane("right", plane), vane};
  return deck;
}

const std::vector<Grain> two_grains = {{{-radius, lever, 0.0}, {}, {}, radius},
                                       {{radius, -lever, 0.0}, {}, {}, radius}};

/// The vane at `angle` presses on the grains, each as deep as the plane does: their overlap in m, and its torque in N
/// m.
struct Pressed {
  explicit Pressed(double angle) {
    overlap = std::max(
        0.0, (radius + lever * std::sin(angle) - (plane - radius) * std::cos(angle)) / (1.0 + std::cos(angle)));
    const double modulus = 5e6 / (2.0 * (1.0 - 0.09));
    const double force = 4.0 / 3.0 * modulus * std::sqrt(radius) * std::pow(overlap, 1.5);
    const double along = (plane - radius + overlap) * std::sin(angle) + lever * std::cos(angle);
    torque = 2.0 * force * along;
  }
  double overlap;
  double torque;
};

TEST(TurningServo, GrainsBetweenAVaneAndPlanesArePressedAsHertzSays) {
  for (const double torque : {4e-6, 4e-4, 4e-3}) {
    Scene scene(grains_beside_vane(torque), two_grains);
    Simulation& s = scene.simulation();
    s.begin_phase("any");
    scene.run(60000);
    double low = 0.0, high = 0.1;
    for (int k = 0; k < 60; ++k) {
      const double between = 0.5 * (low + high);
      (Pressed(between).torque > torque ? high : low) = between;
    }
    const Servo& servo = *s.walls()[2].servo;
    EXPECT_NEAR(servo.way(), low, 1e-3 * 2.0 * Pressed(low).overlap / lever) << torque;
    EXPECT_NEAR(servo.force(), torque, 1e-4 * torque);
    EXPECT_TRUE(servo.holds(1e-6));
    const Communicator world(MPI_COMM_WORLD);
    const std::vector<WallLoad> loads =
        measure_wall_loads(world, s.vector_level(), s.walls(), s.materials(), s.particles(), s.wall_contacts());
    EXPECT_NEAR(loads[2].torque.z, -torque, 1e-4 * torque);
    EXPECT_NEAR(loads[0].torque.z + loads[1].torque.z, torque, 1e-3 * torque);
  }
}

TEST(TurningServo, AVaneThatFindsNothingSaysSoOnce) {
  Deck deck = grains_beside_vane(1e-4);
  deck.walls[2].servo.axis_direction = {0.0, 0.0, -1.0};  // away from them
  deck.walls[2].servo.max_angle = 2.0;
  Scene scene(deck, two_grains);
  Simulation& s = scene.simulation();
  s.begin_phase("any");
  std::vector<std::string> told;
  for (int k = 0; k < 12000; k += 7) {
    s.advance(7);
    if (const auto warning = s.take_warning()) told.push_back(*warning);
  }
  ASSERT_EQ(told.size(), 1U);
  EXPECT_NE(told[0].find("wall \"vane\": its servo has come to max_angle = 2 degrees"), std::string::npos) << told[0];
}

TEST(TurningServo, APhaseEndsOnceTheTorqueOnAWallIsReached) {
  constexpr double torque = 4e-4;
  Deck deck = grains_beside_vane(torque);
  PhaseDeck press;
  press.name = "press";
  press.until = PhaseUntil::wall_torque;
  press.wall = "left";
  press.torque = 0.25 * torque;  // of the half that each of the planes comes to bear
  press.max_time = 1.0;
  deck.phases = {press};
  Scene scene(deck, two_grains);
  Simulation& s = scene.simulation();
  const Phase phase(deck.phases[0], s);
  std::optional<std::string> ended;
  while (!(ended = phase.ended_by(s, 10))) s.advance(10);
  EXPECT_EQ(*ended, "wall_torque");
  const Communicator world(MPI_COMM_WORLD);
  const double borne =
      measure_wall_loads(world, s.vector_level(), s.walls(), s.materials(), s.particles(), s.wall_contacts())[0]
          .torque.z;
  EXPECT_GT(borne, 0.25 * torque);
  EXPECT_LT(borne, 0.55 * torque);
}

TEST(TurningServo, TheTorqueOfAPhaseIsAboutItsAxis) {
  Deck deck = grains_beside_vane(4e-4);
  PhaseDeck press;
  press.name = "press";
  press.until = PhaseUntil::wall_torque;
  press.wall = "left";
  press.torque = 1e-5;
  press.max_time = 0.03;
  press.axis_origin = {0.0, lever, 0.0};  // through the grain: no lever
  deck.phases = {press};
  Scene scene(deck, two_grains);
  Simulation& s = scene.simulation();
  const Phase phase(deck.phases[0], s);
  std::optional<std::string> ended;
  while (!(ended = phase.ended_by(s, 10))) s.advance(10);
  EXPECT_EQ(*ended, "max_time");
}

const std::string vane_in_bed = glass + R"(
[domain]
min = [-0.006, -0.006, -0.002]
max = [0.006, 0.006, 0.02]
)" + glass_tube("tube", 0.02) + R"(
[[wall]]
name = "blade"
type = "rectangle"
material = "glass"
corner = [-0.003, 0.0, 0.001]
edge_u = [0.006, 0.0, 0.0]
edge_v = [0.0, 0.0, 0.005]
[wall.servo]
type = "rotation"
torque = "1 uN m"
max_angular_velocity = 20.0
max_angle = 40.0
tolerance = 1e-3
phases = ["press", "rest"]
[[wall]]
name = "across"
type = "rectangle"
material = "glass"
moves_with = "blade"
corner = [0.0, -0.003, 0.001]
edge_u = [0.0, 0.006, 0.0]
edge_v = [0.0, 0.0, 0.005]
)" + glass_beads(450, 0.012) + R"(
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

/// With the torques on the vane about its axis.
ServoOutcome run(const Communicator& comm, const std::vector<std::string>& overrides = {},
                 VectorLevel level = best_vector_level()) {
  return run_servo(comm, vane_in_bed, overrides, level,
                   [](const std::vector<WallLoad>& walls) { return -(walls[1].torque.z + walls[2].torque.z); });
}

TEST(TurningServo, AVaneComesToRestInABedAgainstItsTorque) {
  const Communicator world(MPI_COMM_WORLD);
  const ServoOutcome outcome = run(world);
  ASSERT_EQ(outcome.ended_by.size(), 3U);
  EXPECT_EQ(outcome.ended_by[1], "servo");
  for (const double torque : outcome.loads) EXPECT_NEAR(torque, 1e-6, 1e-6 * 1e-3);
  for (const double angle : outcome.ways) {
    EXPECT_NEAR(angle, outcome.ways.front(), 1e-6 / 3e-3);  // 1e-3 of a grain at its edge
  }
  EXPECT_GT(outcome.ways.front(), 1e-3);
}

TEST(TurningServo, SameBitsOnAllRanksAsOnOne) { expect_the_bits_of_one_rank(run); }

TEST(TurningServo, SameBitsWhateverTheListsAndTheVectors) { expect_the_bits_of_other_lists_and_vectors(run); }

}  // namespace
}  // namespace repose::test
