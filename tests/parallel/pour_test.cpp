#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "measurement/state_hash.h"
#include "scene/particles/sphere_mass.h"
#include "simulation/phases.h"
#include "simulation/simulation.h"
#include "support/scenes.h"

namespace repose {
namespace {

constexpr double timestep = 1e-5;

/// 50 grains of 2 mm at 1000 per second through a disc of 10 mm radius, downwards at 1 m/s; nothing else.
Deck pouring_deck() {
  Deck deck = test::bare_deck({}, timestep);
  deck.gravity = {0.0, 0.0, -9.81};
  deck.time.expected_speed = 3.0;
  ParticlesDeck pour;
  pour.type = ParticlesType::pour;
  pour.material = "grain";
  pour.diameter = 2e-3;
  pour.count = 50;
  pour.region = RegionShape::disc;
  pour.radius = 10e-3;
  pour.particle_rate = 1000.0;
  pour.start_time = 0.01;
  pour.interval = 2e-3;
  pour.velocity = {0.2, 0.0, -1.0};
  deck.particles = {pour};
  return deck;
}

std::string no_file(const std::string&) { return {}; }

class PourTest : public ::testing::Test {
 protected:
  Communicator comm_{MPI_COMM_WORLD};
  Simulation make(const Deck& deck) { return Simulation(comm_, deck, no_file, best_vector_level()); }
  std::string hash(const Simulation& s) { return state_hash(comm_, s.particles(), s.pairs(), s.wall_contacts()); }
};

TEST_F(PourTest, ComesAtTheRateInBatches) {
  Simulation s = make(pouring_deck());
  EXPECT_EQ(s.planned(), 50);
  EXPECT_EQ(s.inserted(), 0);
  s.advance(1199);  // 0.01199 s; the first batch is due at 0.012 s
  EXPECT_EQ(s.inserted(), 0);
  s.advance(1);
  EXPECT_EQ(s.inserted(), 2);
  s.advance(2000);
  EXPECT_EQ(s.inserted(), 22);
  s.advance(3000);
  EXPECT_EQ(s.inserted(), 50);
  EXPECT_EQ(comm_.sum(static_cast<std::int64_t>(s.particles().owned)), 50);
  EXPECT_FALSE(s.awaits_particles());
}

TEST_F(PourTest, ComesAtTheMassRate) {
  Deck deck = pouring_deck();
  const double mass = sphere_mass(1e-3, 3592.0);
  deck.particles[0].particle_rate = unset;
  deck.particles[0].rate = 500.0 * mass;
  Simulation s = make(deck);
  s.advance(3000);
  EXPECT_NEAR(static_cast<double>(s.inserted()), 10.0, 1.0);
}

// A grain enters with the velocity of the deck and falls freely: velocity Verlet is exact for it.
TEST_F(PourTest, FallsFreelyFromTheDisc) {
  Simulation s = make(pouring_deck());
  constexpr std::int64_t steps = 400;
  s.advance(1200 + steps);
  const double t = steps * timestep;
  for (std::size_t i = 0; i < s.particles().owned; ++i) {
    if (s.particles().id[i] >= 2) continue;  // later batches
    const ParticleRecord& p = s.particles().record[i];
    EXPECT_NEAR(p.velocity.z, -1.0 - 9.81 * t, 1e-12);
    EXPECT_NEAR(p.position.z, -t - 0.5 * 9.81 * t * t, 1e-15);
    EXPECT_LE(std::hypot(p.position.x - 0.2 * t, p.position.y), 9e-3);
  }
}

TEST_F(PourTest, SameBitsHoweverTheListsAndRanksAre) {
  Deck deck = pouring_deck();
  deck.particles[0].particle_rate = 5000.0;
  deck.particles[0].count = 200;
  deck.particles[0].start_time = 0.0;
  SizesDeck& sizes = deck.particles[0].sizes;
  sizes.enabled = true;
  sizes.type = SizesType::uniform;
  sizes.min_diameter = 1e-3;
  sizes.max_diameter = 3e-3;
  deck.particles[0].diameter = unset;
  deck.walls = {test::floor_at(-0.02)};
  Simulation s = make(deck);
  s.advance(5000);  // the first have hit the floor
  const Communicator alone(MPI_COMM_SELF);
  for (const double skin : {0.05, 1.0}) {
    deck.neighbours.skin = skin;
    Simulation other(alone, deck, no_file, best_vector_level());
    other.advance(5000);
    EXPECT_EQ(state_hash(alone, other.particles(), other.pairs(), other.wall_contacts()), hash(s));
    EXPECT_EQ(other.inserted(), s.inserted());
  }
  EXPECT_EQ(s.inserted(), 200);
}

TEST_F(PourTest, NumbersAreThoseOfTheDeckOrder) {
  Deck deck = pouring_deck();
  ParticlesDeck lattice;
  lattice.type = ParticlesType::lattice;
  lattice.material = "grain";
  lattice.diameter = 1e-3;
  lattice.spacing = 2e-3;
  lattice.counts = {2, 2, 2};
  lattice.first = {1.0, 1.0, 1.0};
  deck.particles.push_back(lattice);
  Simulation s = make(deck);
  EXPECT_EQ(s.inserted(), 8);
  EXPECT_EQ(s.planned(), 58);
  for (std::size_t i = 0; i < s.particles().owned; ++i) EXPECT_GE(s.particles().id[i], 50);
}

TEST_F(PourTest, APhaseDoesNotTakeAnEmptySceneForRest) {
  Simulation s = make(pouring_deck());
  PhaseDeck deck;
  deck.name = "pour";
  deck.until = PhaseUntil::kinetic_energy;
  deck.kinetic_energy = 1e30;  // always holds, once it is asked
  deck.max_time = 1.0;
  const Phase phase(deck, s);
  EXPECT_FALSE(phase.ended_by(s, 1));  // nothing has come
  s.advance(3000);
  EXPECT_FALSE(phase.ended_by(s, 1));  // some have
  s.advance(3400);
  EXPECT_EQ(phase.ended_by(s, 1), "kinetic_energy");
}

TEST_F(PourTest, WaitsForRoomAndEndsWhenThereIsNone) {
  Deck deck = pouring_deck();
  deck.particles[0].radius = 1.5e-3;  // room for one at a time
  deck.particles[0].start_time = 0.0;
  Simulation late = make(deck);
  late.advance(3000);
  EXPECT_LE(late.inserted(), 15);  // one in each batch of 2 ms, where two are due
  EXPECT_GE(late.inserted(), 14);
  deck.gravity = {};
  deck.particles[0].velocity = {0.0, 0.0, -1e-3};  // the first stays where it is
  deck.particles[0].interval = 20 * timestep;
  deck.particles[0].particle_rate = 1e5;
  Simulation stuck = make(deck);
  std::string message = "no error";
  try {
    stuck.advance(1200);
  } catch (const PhysicsError& error) {
    message = error.what();
  }
  EXPECT_NE(message.find("[[particles]] number 1 (pour): 49 particles find no room"), std::string::npos) << message;
  EXPECT_NE(message.find("1 of the 50 that are due have entered; take a particle_rate of at most 98 1/s"),
            std::string::npos)
      << message;
}

}  // namespace
}  // namespace repose
