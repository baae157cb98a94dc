// Walls that move with another as one rigid body: as if each had the motions itself, one load for the servo, those of
// the body alone that are there.
#include <cmath>

#include <gtest/gtest.h>

#include "deck/read_deck.h"
#include "simulation/phases.h"
#include "simulation/simulation.h"
#include "simulation_counts.h"
#include "support/glass_beads.h"
#include "support/scenes.h"

namespace repose::test {
namespace {

const std::string blades = glass + R"(
[domain]
min = [-0.006, -0.006, -0.002]
max = [0.006, 0.006, 0.02]
)" + glass_tube("tube", 0.02) +
                           R"(
[[wall.motion]]
type = "rotation"
angular_velocity = 12.0
phases = ["turn"]
[[wall]]
name = "long"
type = "rectangle"
material = "glass"
corner = [-0.004, 0.0, 0.001]
edge_u = [0.008, 0.0, 0.0]
edge_v = [0.0, 0.0, 0.004]
MOVED
[[wall]]
name = "short"
type = "rectangle"
material = "glass"
corner = [0.0, -0.003, 0.001]
edge_u = [0.0, 0.006, 0.0]
edge_v = [0.0, 0.0, 0.003]
MOVED
)" + glass_beads(250, 0.012) +
                           R"(
[[phase]]
name = "fall"
until = "steps"
steps = 2000
[[phase]]
name = "turn"
until = "steps"
steps = 2000
)";

std::string moved_by(const std::string& keys) {
  const std::string word = "MOVED";
  std::string text = blades;
  for (std::size_t at = 0; (at = text.find(word)) != std::string::npos;) text.replace(at, word.size(), keys);
  return text;
}

const char* const own_motion = R"([[wall.motion]]
type = "rotation"
angular_velocity = 12.0
phases = ["turn"]
)";

/// After the fall and after the turn.
std::vector<std::string> hashes(const Communicator& comm, const std::string& text,
                                const std::vector<std::string>& overrides = {}) {
  const Deck deck = read_deck(text, "blades.toml", overrides);
  Simulation s(comm, deck, {}, best_vector_level());
  std::vector<std::string> all;
  for (const PhaseDeck& phase : deck.phases) {
    s.begin_phase(phase.name);
    s.advance(phase.steps);
    s.check_guards();
    all.push_back(hash_of(s));
  }
  return all;
}

TEST(MovesWith, IsTheSameBitsAsTheMotionsOfTheLeader) {
  const Communicator world(MPI_COMM_WORLD);
  // The tube turns in itself and stays where it is; the blades, which do not, go around with it.
  const std::vector<std::string> own = hashes(world, moved_by(own_motion));
  EXPECT_EQ(hashes(world, moved_by("moves_with = \"tube\"")), own);
  EXPECT_EQ(hashes(world, moved_by("moves_with = \"tube\""), {"neighbours.skin=0.8", "neighbours.inner_skin=0.1"}),
            own);
  EXPECT_NE(hashes(world, moved_by("")), own);
}

TEST(MovesWith, IsTheSameBitsOnAllRanksAsOnOne) {
  const Communicator world(MPI_COMM_WORLD);
  const Communicator self(MPI_COMM_SELF);
  const std::string text = moved_by("moves_with = \"tube\"");
  const std::vector<std::string> together = hashes(world, text);
  if (world.is_root()) {
    EXPECT_EQ(hashes(self, text), together);
  }
  world.barrier();
}

WallDeck half_lid(const std::string& name, double x_min) {
  WallDeck lid;
  lid.name = name;
  lid.type = WallType::rectangle;
  lid.material = "wall";
  lid.corner = {x_min, -0.005, 2.1e-3};
  lid.edge_u = {0.005, 0.0, 0.0};
  lid.edge_v = {0.0, 0.01, 0.0};
  return lid;
}

constexpr double force = 0.02;  // N

/// A grain of 1 mm below each half of a lid that is pressed down on a plane.
Deck two_halves() {
  Deck deck = bare_deck({}, 1e-6);
  WallDeck left = half_lid("left", -0.005);
  left.servo.enabled = true;
  left.servo.direction = {0.0, 0.0, -1.0};
  left.servo.force = force;
  left.servo.max_speed = 0.1;
  left.servo.max_way = 1e-3;
  WallDeck right = half_lid("right", 0.0);
  right.moves_with = "left";
  deck.walls = {floor_at(0.0), right, left};
  return deck;
}

/// m, by which a lid has to come down on a grain that it is to press with `load` N (Hertz, on either side).
double way_for(double load) {
  const double modulus = 5e6 / (2.0 * (1.0 - 0.09));
  return 1e-4 + 2.0 * std::pow(0.75 * load / (modulus * std::sqrt(1e-3)), 2.0 / 3.0);
}

class HalfLids : public testing::Test {
 protected:
  void expect_way(double load) {
    scene_.run(30000);
    const Servo& servo = *scene_.simulation().walls()[2].servo;
    EXPECT_NEAR(servo.way(), way_for(load), 1e-3 * (way_for(load) - 1e-4));
    EXPECT_NEAR(servo.force(), force, 1e-3 * force);
    EXPECT_TRUE(scene_.simulation().scene().servos_hold(1e-6));
  }

  Scene scene_{two_halves(), {{{-2.5e-3, 0.0, 1e-3}, {}, {}, 1e-3}, {{2.5e-3, 0.0, 1e-3}, {}, {}, 1e-3}}};
  Simulation& simulation_ = scene_.simulation();
};

TEST_F(HalfLids, ShareTheForceOfOneServo) {
  simulation_.begin_phase("any");
  expect_way(0.5 * force);
}

TEST_F(HalfLids, EndAPhaseByWhatPressesOnBoth) {
  PhaseDeck press;
  press.name = "press";
  press.until = PhaseUntil::wall_force;
  press.wall = "left";
  press.force = 0.8 * force;  // more than either bears
  press.max_time = 0.03;
  const Phase phase(press, simulation_);
  std::optional<std::string> ended;
  while (!(ended = phase.ended_by(simulation_, 10))) simulation_.advance(10);
  EXPECT_EQ(*ended, "wall_force");
}

TEST_F(HalfLids, CountOnlyWhileTheyAreThere) {
  simulation_.begin_phase("any");
  simulation_.set_wall_present("right", false);
  expect_way(force);
  simulation_.set_wall_present("right", true);
  expect_way(0.5 * force);
  simulation_.set_wall_present("left", false);  // the leader, which takes the other along: the servo rests
  const double way = simulation_.walls()[2].servo->way();
  scene_.run(1000);
  EXPECT_EQ(simulation_.walls()[2].servo->way(), way);
  EXPECT_FALSE(simulation_.scene().servos_hold(1e-6));
}

}  // namespace
}  // namespace repose::test
