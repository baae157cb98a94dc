// Walls that move, held and fixed particles and a tilting gravity leave the same bits on any number of ranks and
// whatever the lists; and what they do is what they should.
#include <cmath>

#include <gtest/gtest.h>

#include "deck/read_deck.h"
#include "measurement/wall_loads.h"
#include "simulation/phases.h"
#include "simulation/simulation.h"
#include "simulation_counts.h"
#include "support/glass_beads.h"

namespace repose::test {
namespace {

const std::string driven_scene = glass + R"(
[domain]
min = [-0.03, -0.02, -0.02]
max = [0.03, 0.02, 0.05]
[[wall]]
name = "drum"
type = "profile"
material = "glass"
points = [[0.0, -0.008], [0.015, -0.008], [0.015, 0.008], [0.0, 0.008]]
axis_direction = [0.0, 1.0, 0.0]
[[wall.motion]]
type = "rotation"
axis_direction = [0.0, 1.0, 0.0]
angular_velocity = 20.0
phases = ["drive"]
[[wall]]
name = "paddle"
type = "rectangle"
material = "glass"
corner = [0.009, -0.007, 0.0]
edge_u = [0.0025, 0.0, 0.0]
edge_v = [0.0, 0.014, 0.0]
[[wall.motion]]
type = "rotation"
axis_direction = [0.0, 1.0, 0.0]
angular_velocity = 30.0
[[wall.motion]]
type = "oscillation"
amplitude = [0.0, 0.0, 0.0005]
frequency = 40.0
phases = ["drive"]
[[particles]]
type = "fill"
material = "glass"
diameter = 0.0014
count = 450
region = "box"
min = [-0.0095, -0.0075, -0.0105]
max = [0.0095, 0.0075, -0.0015]
spacing = 0.0015
[[particles]]
type = "fill"
material = "glass"
diameter = 0.002
count = 1
region = "box"
min = [0.0093, -0.002, 0.0015]
max = [0.0117, 0.002, 0.0039]
[[particles.motion]]
type = "rotation"
axis_direction = [0.0, 1.0, 0.0]
angular_velocity = 30.0
[[particles]]
type = "fill"
material = "glass"
fixed = true
diameter = 0.001
count = 3
jitter = 0.0
region = "box"
min = [-0.0006, -0.0075, -0.015]
max = [0.0006, 0.0075, -0.0139]
[tilt]
angular_velocity = 5.0
phases = ["drive"]
[[phase]]
name = "fall"
until = "steps"
steps = 2000
[[phase]]
name = "drive"
until = "steps"
steps = 4000
)";

struct Outcome {
  std::vector<std::string> hashes;
  std::vector<WallLoad> loads;  ///< of the drum and the paddle, at the time of each hash
  std::int64_t rebuilds = 0;
  Vec3 gravity;
};

Outcome run(const Communicator& comm, const std::vector<std::string>& overrides,
            VectorLevel level = best_vector_level()) {
  const Deck deck = read_deck(driven_scene, "driven.toml", overrides);
  Simulation s(comm, deck, {}, level);
  Outcome outcome;
  for (const PhaseDeck& phase_deck : deck.phases) {
    const Phase phase(phase_deck, s);
    for (int part = 0; part < 4; ++part) {
      s.advance(phase_deck.steps / 4);
      s.check_guards();
      for (const WallLoad& load :
           measure_wall_loads(comm, level, s.walls(), s.materials(), s.particles(), s.wall_contacts())) {
        outcome.loads.push_back(load);
      }
      outcome.hashes.push_back(hash_of(s));
    }
  }
  outcome.rebuilds = s.counters().rebuilds;
  outcome.gravity = s.scene().gravity();
  return outcome;
}

void expect_same(const Outcome& a, const Outcome& b) {
  EXPECT_EQ(a.hashes, b.hashes);
  ASSERT_EQ(a.loads.size(), b.loads.size());
  for (std::size_t w = 0; w < a.loads.size(); ++w) {
    EXPECT_EQ(a.loads[w].force, b.loads[w].force);
    EXPECT_EQ(a.loads[w].torque, b.loads[w].torque);
  }
}

TEST(DrivenScene, SameBitsOnAllRanksAsOnOne) {
  const Communicator world(MPI_COMM_WORLD);
  const Communicator self(MPI_COMM_SELF);
  const Outcome together = run(world, {});
  EXPECT_GT(together.rebuilds, 6000 / 320);
  double on_paddle = 0.0;
  for (std::size_t k = 1; k < together.loads.size(); k += 2) on_paddle += norm(together.loads[k].force);
  EXPECT_GT(on_paddle, 0.0);
  if (world.is_root()) expect_same(run(self, {}), together);
  world.barrier();
}

TEST(DrivenScene, SameBitsWhateverTheListsAndTheVectors) {
  const Communicator self(MPI_COMM_SELF);
  const Communicator world(MPI_COMM_WORLD);
  if (world.is_root()) {
    const Outcome plain = run(self, {});
    expect_same(run(self, {"neighbours.skin=0.8", "neighbours.inner_skin=0.1"}), plain);
    expect_same(run(self, {}, VectorLevel::sse2), plain);
  }
  world.barrier();
}

TEST(DrivenScene, TheApparatusTurnsAndGravityTheOtherWay) {
  const Communicator self(MPI_COMM_SELF);
  const Communicator world(MPI_COMM_WORLD);
  if (world.is_root()) {
    const double angle = 5.0 * 4000 * 1e-5;
    const Vec3 g = run(self, {}).gravity;  // about y by -0.2 rad
    EXPECT_NEAR(g.x, 9.81 * std::sin(angle), 1e-12);
    EXPECT_NEAR(g.z, -9.81 * std::cos(angle), 1e-12);
  }
  world.barrier();
}

// A grain that is glued into a plate, its centre in the surface.
TEST(DrivenScene, HeldParticlesFeelNoWallOfAnyKind) {
  const Communicator world(MPI_COMM_WORLD);
  const std::string plates[] = {
      "type = \"rectangle\"\ncorner = [-0.01, -0.01, 0.0]\nedge_u = [0.02, 0.0, 0.0]\nedge_v = [0.0, 0.02, 0.0]\n",
      "type = \"plane\"\npoint = [0.0, 0.0, 0.0]\n", "type = \"mesh\"\nfile = \"plate.stl\"\n"};
  const auto stl = [](const std::string&) {
    return std::string("solid plate\nfacet normal 0 0 1\nouter loop\nvertex -0.01 -0.01 0\nvertex 0.01 -0.01 0\n") +
           "vertex 0 0.01 0\nendloop\nendfacet\nendsolid plate\n";
  };
  for (const std::string& plate : plates) {
    const std::string text =
        glass + "[domain]\nmin = [-0.01, -0.01, -0.01]\nmax = [0.01, 0.01, 0.01]\n[[wall]]\n" +
        "name = \"plate\"\nmaterial = \"glass\"\n" + plate + "[[particles]]\ntype = \"lattice\"\n" +
        "material = \"glass\"\ndiameter = 0.001\ncounts = [1, 1, 1]\nspacing = 0.002\n" +
        "first = [0.0, 0.0, 0.0]\nfixed = true\n[[phase]]\nname = \"rest\"\nuntil = \"steps\"\nsteps = 10\n";
    Simulation s(world, read_deck(text, "glued.toml", {}), stl, best_vector_level());
    s.advance(10);
    s.check_guards();
    EXPECT_TRUE(s.wall_contacts().contacts(s.walls(), s.particles()).empty()) << plate;
  }
}

// A list may give them velocities, which must neither be felt by what lies on them nor shorten the time step.
TEST(DrivenScene, HeldParticlesForgetTheVelocityOfTheirFile) {
  const Communicator world(MPI_COMM_WORLD);
  const std::string text = glass + "[domain]\nmin = [-0.01, -0.01, -0.01]\nmax = [0.01, 0.01, 0.01]\n" +
                           "[[particles]]\ntype = \"csv\"\nfile = \"plate.csv\"\nfixed = true\n" +
                           "[[particles]]\ntype = \"csv\"\nfile = \"grain.csv\"\n" +
                           "[[phase]]\nname = \"rest\"\nuntil = \"steps\"\nsteps = 10\n";
  const auto grain_on_plate_at = [&](const std::string& velocity) {
    const auto files = [&](const std::string& file) {
      return "x,y,z,vx,vy,vz,wx,wy,wz,radius,material\n" +
             (file == "plate.csv" ? "0,0,0," + velocity : "0,0,0.000999,0,0,0,0,0,0") + ",0.0005,glass\n";
    };
    Simulation s(world, read_deck(text, "plate.toml", {}), files, best_vector_level());
    s.advance(10);
    s.check_guards();
    return std::pair(hash_of(s), s.time_step().speed);
  };
  EXPECT_EQ(grain_on_plate_at("0,0,1,0,300,0"), grain_on_plate_at("0,0,0,0,0,0"));
}

TEST(DrivenScene, HeldParticlesFollowTheirPath) {
  const Communicator world(MPI_COMM_WORLD);
  const Deck deck = read_deck(driven_scene, "driven.toml", {});
  Simulation s(world, deck, {}, best_vector_level());
  const Phase phase(deck.phases[0], s);
  s.advance(1000);
  const double angle = 30.0 * 1000 * 1e-5;  // of particle 450 about y, from (10.5, 0, 2.7) mm
  const Vec3 start = {0.0105, 0.0, 0.0027};
  const double x = std::cos(angle) * start.x + std::sin(angle) * start.z;
  const double z = std::cos(angle) * start.z - std::sin(angle) * start.x;
  const Particles& p = s.particles();
  std::int64_t driven = 0, others = 0;
  for (std::size_t i = 0; i < p.owned; ++i) {
    driven += p.id[i] == 450 ? 1 : 0;
    others += p.id[i] > 450 ? 1 : 0;
    if (p.id[i] == 450) {
      EXPECT_NEAR(p.record[i].position.x, x, 1.5e-4);  // where the lattice put it, to within its jitter
      EXPECT_NEAR(p.record[i].position.z, z, 1.5e-4);
      EXPECT_NEAR(p.record[i].velocity.x, 30.0 * p.record[i].position.z, 1e-12);
      EXPECT_EQ(p.record[i].spin, (Vec3{0.0, 30.0, 0.0}));
    }
    if (p.id[i] > 450) {
      EXPECT_EQ(p.record[i].velocity, Vec3{});
      EXPECT_EQ(p.record[i].spin, Vec3{});
      EXPECT_NEAR(p.record[i].position.z, -0.0145, 1e-17);
    }
  }
  EXPECT_EQ(world.sum(driven), 1);
  EXPECT_EQ(world.sum(others), s.planned() - 451);
}

}  // namespace
}  // namespace repose::test
