#include <cmath>
#include <optional>
#include <string>

#include <fmt/format.h>
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
  std::int64_t of_first_batch = 0;
  for (std::size_t i = 0; i < s.particles().owned; ++i) {
    if (s.particles().id[i] >= 2) continue;  // later batches
    ++of_first_batch;
    const ParticleRecord& p = s.particles().record[i];
    EXPECT_NEAR(p.velocity.z, -1.0 - 9.81 * t, 1e-12);
    EXPECT_NEAR(p.position.z, -t - 0.5 * 9.81 * t * t, 1e-15);
    EXPECT_LE(std::hypot(p.position.x - 0.2 * t, p.position.y), 9e-3);
  }
  EXPECT_EQ(comm_.sum(of_first_batch), 2);
}

TEST_F(PourTest, ThatBeginsInAnEternityNeverDoes) {
  for (const double eternity : {1e10, 1e18, 1e100}) {
    Deck deck = pouring_deck();
    deck.particles[0].interval = eternity;
    Simulation at_long_intervals = make(deck);
    at_long_intervals.advance(3000);
    EXPECT_EQ(at_long_intervals.inserted(), 0) << eternity;
    deck = pouring_deck();
    deck.particles[0].start_time = eternity;
    Simulation late = make(deck);
    late.advance(3000);
    EXPECT_EQ(late.inserted(), 0) << eternity;
  }
}

/// An L of three squares of 10 mm in the plane z = 0, the inner corner at (10, 10) mm.
std::string l_shaped_stl() {
  std::string stl = "solid L\n";
  for (const auto& [x, y] : {std::pair{0, 0}, std::pair{1, 0}, std::pair{0, 1}}) {
    for (const auto& [dx, dy] : {std::pair{1, 0}, std::pair{0, 1}}) {
      stl += fmt::format(
          "facet normal 0 0 1\nouter loop\nvertex {0} {1} 0\nvertex {2} {3} 0\nvertex {4} {5} 0\n"
          "endloop\nendfacet\n",
          x, y, x + dx, y + dy, x + 1, y + 1);
    }
  }
  return stl + "endsolid L\n";
}

Deck face_deck() {
  Deck deck = pouring_deck();
  deck.particles[0].region = RegionShape::face;
  deck.particles[0].face = "inlet";
  deck.particles[0].velocity = {0.0, 0.0, -1.0};
  deck.particles[0].count = 400;
  deck.particles[0].particle_rate = 5000.0;
  WallDeck inlet = test::floor_at(0.0);
  inlet.name = "inlet";
  inlet.type = WallType::mesh;
  inlet.file = "inlet.stl";
  inlet.scale = 0.01;
  inlet.present = false;
  deck.walls = {inlet};
  return deck;
}

TEST_F(PourTest, EntersThroughAFaceOfAnyOutline) {
  const auto files = [](const std::string&) { return l_shaped_stl(); };
  Simulation s(comm_, face_deck(), files, best_vector_level());
  s.advance(9500);
  EXPECT_EQ(s.inserted(), 400);
  constexpr double r = 1e-3 * (1.0 - 1e-8);
  std::int64_t far_square = 0;
  for (std::size_t i = 0; i < s.particles().owned; ++i) {
    const Vec3& p = s.particles().record[i].position;
    EXPECT_GE(std::min(p.x, p.y), r);
    EXPECT_LE(std::max(p.x, p.y), 0.02 - r);
    const bool clear_of_the_inner_corner = p.x < 0.01 && p.y < 0.01 && std::hypot(0.01 - p.x, 0.01 - p.y) >= r;
    EXPECT_TRUE(p.x <= 0.01 - r || p.y <= 0.01 - r || clear_of_the_inner_corner) << p.x << ' ' << p.y;
    far_square += p.x > 0.01 ? 1 : 0;
  }
  // Centres have 9 x 8 of 18 x 8 + 8 x 10 + (1 - pi / 4) mm2 there; the binomial has a deviation of 9.3.
  EXPECT_NEAR(static_cast<double>(comm_.sum(far_square)), 400.0 * 72.0 / 224.2, 5.0 * 9.3);
  Deck deck = face_deck();
  deck.neighbours.skin = 1.0;
  Simulation other(comm_, deck, files, VectorLevel::sse2);
  other.advance(9500);
  EXPECT_EQ(hash(s), hash(other));
  const Communicator self(MPI_COMM_SELF);
  Simulation alone(self, face_deck(), files, best_vector_level());
  alone.advance(9500);
  EXPECT_EQ(hash(s), state_hash(self, alone.particles(), alone.pairs(), alone.wall_contacts()));
}

TEST_F(PourTest, RefusesAFaceThatIsNoneOrTooSmall) {
  const auto files = [](const std::string&) { return l_shaped_stl(); };
  const auto message = [&](const Deck& deck) -> std::string {
    try {
      Simulation(comm_, deck, files, best_vector_level());
    } catch (const DeckError& error) {
      return error.what();
    }
    return "";
  };
  Deck deck = face_deck();
  deck.particles[0].diameter = 12e-3;
  EXPECT_NE(message(deck).find("does not fit into the region"), std::string::npos);
  deck = face_deck();
  deck.walls[0].type = WallType::plane;
  EXPECT_NE(message(deck).find("must be a mesh or a rectangle"), std::string::npos);
  deck = face_deck();
  deck.particles[0].face = "outlet";
  EXPECT_NE(message(deck).find("no wall is named \"outlet\""), std::string::npos);
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

// A small grain 1.5 mm before a periodic boundary, and at the same step a large one 0.5 mm behind it.
TEST_F(PourTest, FlowsKeepOutOfEachOthersWayAcrossAPeriodicBoundary) {
  Deck deck = pouring_deck();
  deck.domain.min = {-10e-3, -10e-3, -1.0};
  deck.domain.max = {10e-3, 10e-3, 1.0};
  deck.domain.periodic = {Axis::x};
  ParticlesDeck& small = deck.particles[0];
  small.count = 1;
  small.normal = {1.0, 0.0, 0.0};
  small.velocity = {0.0, 0.0, -1.0};
  ParticlesDeck large = small;
  small.diameter = 1e-3;
  small.radius = 0.51e-3;  // little more than its own
  small.centre = {8.5e-3, 0.0, 0.0};
  large.diameter = 4e-3;
  large.radius = 2.01e-3;
  large.centre = {-9.5e-3, 0.0, 0.0};
  deck.particles.push_back(large);
  Simulation s = make(deck);
  s.advance(1201);
  EXPECT_EQ(s.inserted(), 1);
  s.advance(400);  // the small one has fallen out of the way
  s.check_guards();
  EXPECT_EQ(s.inserted(), 2);
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

TEST_F(PourTest, ALoadOnAWallEndsAPhaseWhileParticlesAreStillToCome) {
  Deck scene = pouring_deck();
  scene.walls = {test::floor_at(-5e-3)};
  Simulation s = make(scene);
  PhaseDeck deck;
  deck.name = "pour";
  deck.until = PhaseUntil::wall_force;
  deck.wall = scene.walls[0].name;
  deck.force = 1e-4;
  deck.max_time = 1.0;
  const Phase phase(deck, s);
  std::optional<std::string> ended;
  while (!ended && s.awaits_particles()) {
    s.advance(10);
    ended = phase.ended_by(s, 10);
  }
  EXPECT_EQ(ended, "wall_force");
  EXPECT_TRUE(s.awaits_particles());
}

TEST_F(PourTest, IsRefusedInAPhaseWithoutMechanics) {
  for (const bool any_before : {false, true}) {
    Deck deck = pouring_deck();
    deck.heat.enabled = true;
    for (MaterialDeck& m : deck.materials) m.conductivity = m.specific_heat = 1.0;
    PhaseDeck rest;
    rest.name = "rest";
    rest.mechanics = false;
    deck.phases = {rest};
    Simulation s = make(deck);
    if (any_before) s.advance(1200);  // two have come
    s.begin_phase("rest");
    std::string message;
    try {
      s.advance(1500);
      s.check_guards();
    } catch (const PhysicsError& error) {
      message = error.what();
    }
    EXPECT_TRUE(message.starts_with(any_before ? "step 1400: particles are to be poured in a phase without mechanics"
                                               : "step 1200: particles are to be poured in a phase without mechanics"))
        << message;
  }
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
