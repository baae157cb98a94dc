// Periodic directions: the same bits on any number of ranks and with any lists, whichever image of a particle is kept.
#include <gtest/gtest.h>

#include "base/error.h"
#include "measurement/energies.h"
#include "simulation_counts.h"
#include "support/draw.h"
#include "support/scenes.h"

namespace repose::test {
namespace {

constexpr double radius = 5e-4;

/// Grains that fall on a floor and slide down it, several times through a box of 8 by 6 mm; gravity is tilted by about
/// 35 degrees.
Deck chute() {
  Deck deck = bare_deck({}, 1e-5);
  deck.gravity = {5.6, 0.0, -8.0};
  deck.domain = {{0.0, -0.003, -0.001}, {0.008, 0.003, 0.1}, {Axis::x, Axis::y}};
  deck.walls.push_back(floor_at(0.0));
  ParticlesDeck fill;
  fill.material = "grain";
  fill.diameter = 2.0 * radius;
  fill.count = 150;
  fill.region = RegionShape::box;
  fill.min = {0.0, -0.003, 0.0};
  fill.max = {0.008, 0.003, 0.01};
  fill.spacing = 1.3e-3;
  fill.velocity = {1.5, -0.4, -0.2};
  deck.particles = {fill};
  return deck;
}

struct Outcome {
  std::vector<std::string> hashes;
  double lengths = 0.0;  ///< of the domain that a grain has passed on average
  std::int64_t contacts = 0;
  std::int64_t inside = 0;
  double pairs_per_step = 0.0;  ///< evaluated by this rank
  RunCounters counters;
};

Outcome run(const Communicator& comm, const Deck& deck, VectorLevel level = best_vector_level()) {
  Simulation s(comm, deck, {}, level);
  Outcome outcome;
  for (int part = 0; part < 8; ++part) {
    s.advance(301);
    s.check_guards();
    outcome.hashes.push_back(hash_of(s));
    double speed = 0.0;
    for (std::size_t i = 0; i < s.particles().owned; ++i) speed += s.particles().record[i].velocity.x;
    outcome.lengths += comm.sum(speed) / static_cast<double>(s.inserted()) * 301 * s.time_step().step / 0.008;
  }
  outcome.contacts = count_contacts(comm, s.particles(), s.pairs(), s.walls(), s.wall_contacts()).pairs;
  outcome.inside = inside(s);
  outcome.pairs_per_step = s.load().pairs_per_step();
  outcome.counters = s.counters();
  return outcome;
}

TEST(Periodic, SameBitsOnAllRanksAsOnOne) {
  const Communicator world(MPI_COMM_WORLD);
  const Communicator self(MPI_COMM_SELF);
  const Outcome together = run(world, chute());
  EXPECT_EQ(together.inside, 150);
  EXPECT_GT(together.lengths, 3.0);
  EXPECT_GT(together.contacts, 15);
  EXPECT_GT(together.counters.rebuilds, 10);
  if (world.is_root()) {
    const Outcome alone = run(self, chute());
    EXPECT_EQ(together.hashes, alone.hashes);
    EXPECT_EQ(together.contacts, alone.contacts);
    for (std::size_t k = 1; k < alone.hashes.size(); ++k) EXPECT_NE(alone.hashes[k], alone.hashes[k - 1]);
  }
  world.barrier();
}

TEST(Periodic, SameBitsWhateverTheLists) {
  const Communicator world(MPI_COMM_WORLD);
  Deck deck = chute();
  const Outcome usual = run(world, deck);
  deck.neighbours.skin = 1.2;
  deck.neighbours.inner_skin = 0.3;
  deck.neighbours.max_imbalance = 1.5;
  const Outcome thick = run(world, deck);
  deck.neighbours.skin = 0.02;
  deck.neighbours.inner_skin = 0.01;
  const Outcome thin = run(world, deck);
  EXPECT_EQ(usual.hashes, thick.hashes);
  EXPECT_EQ(usual.hashes, thin.hashes);
  EXPECT_NE(usual.pairs_per_step, thin.pairs_per_step);
  EXPECT_NE(usual.pairs_per_step, thick.pairs_per_step);
}

TEST(Periodic, SameBitsAtEveryVectorLevel) {
  const Communicator world(MPI_COMM_WORLD);
  EXPECT_EQ(run(world, chute(), VectorLevel::sse2).hashes, run(world, chute()).hashes);
}

/// The floor as a rectangle that ends where the domain does, or as several that meet inside; no piece: as a plane that
/// is level up to rounding only.
Deck on_pieces(int pieces) {
  Deck deck = chute();
  if (pieces == 0) {
    deck.walls[0].normal.x = 1e-9;
    deck.gravity = {3.0, 0.0, -9.0};
    deck.particles[0].velocity = {0.3, -0.1, -0.2};  // slow enough to be past a boundary without a rebuild
    return deck;
  }
  deck.walls.clear();
  const double length = 0.008 / pieces;
  for (int k = 0; k < pieces; ++k) {
    WallDeck wall = floor_at(0.0);
    wall.name = "floor_" + std::to_string(k);
    wall.type = WallType::rectangle;
    wall.corner = {length * k, -0.003, 0.0};
    wall.edge_u = {length, 0.0, 0.0};
    wall.edge_v = {0.0, 0.006, 0.0};
    deck.walls.push_back(wall);
  }
  return deck;
}

TEST(Periodic, AFloorThatEndsAtTheBoundaryIsFeltAsWhole) {
  const Communicator world(MPI_COMM_WORLD);
  const Communicator self(MPI_COMM_SELF);
  for (const int pieces : {0, 1, 3}) {
    Deck deck = on_pieces(pieces);
    const Outcome together = run(world, deck);
    EXPECT_EQ(together.inside, 150);
    deck.neighbours.skin = 0.8;
    deck.neighbours.inner_skin = 0.4;
    if (world.is_root()) {
      EXPECT_EQ(together.hashes, run(self, deck).hashes);
    }
    world.barrier();
  }
}

/// Half the side of a cubic box whose bounds, and the places of its grains, are multiples of 2^-40 m.
constexpr double half_side = 1.0 / 128.0;

Deck cube(const Coefficients& c, double timestep) {
  Deck deck = bare_deck(c, timestep);
  deck.domain = {{-half_side, -half_side, -half_side}, {half_side, half_side, half_side}, {Axis::x, Axis::y, Axis::z}};
  return deck;
}

/// Two grains that collide obliquely about `centre`.
std::vector<Grain> collision(const Vec3& centre) {
  const double unit = 1.0 / 65536.0;
  return {{centre + Vec3{-30 * unit, -8 * unit, 5 * unit}, {0.5, 0.1, -0.05}, {10.0, -20.0, 30.0}, radius},
          {centre + Vec3{40 * unit, 9 * unit, 0.0}, {-0.6, -0.2, 0.1}, {-5.0, 0.0, 60.0}, 0.8 * radius}};
}

TEST(Periodic, APairAcrossTheBoundaryMovesAsOneInTheMiddle) {
  const double s = half_side;
  for (const Vec3& corner : {Vec3{s, 0, 0}, Vec3{0, -s, 0}, Vec3{0, 0, s}, Vec3{s, -s, 0}, Vec3{-s, s, s}}) {
    std::vector<Grain> across = collision(corner);
    for (Grain& g : across) {
      for (double Vec3::*a : {&Vec3::x, &Vec3::y, &Vec3::z}) {
        if (g.position.*a >= s) g.position.*a -= 2 * s;
        if (g.position.*a < -s) g.position.*a += 2 * s;
      }
    }
    Scene middle(cube({}, 2e-6), collision({}));
    Scene outside(cube({}, 2e-6), across);
    for (int k = 0; k < 20; ++k) {
      middle.run(50);
      outside.run(50);
      const Periodicity& box = middle.simulation().particles().periodic;
      const std::vector<Grain> expected = middle.grains();
      const std::vector<Grain> found = outside.grains();
      for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(found[i].velocity, expected[i].velocity) << "step " << 50 * k;
        EXPECT_EQ(found[i].spin, expected[i].spin);
        EXPECT_EQ(box.wrapped(found[i].position), box.wrapped(expected[i].position + corner));
      }
    }
    EXPECT_LT(middle.grains()[0].velocity.x, 0.0);  // it has bounced
    EXPECT_NE(middle.grains()[0].spin.x, 10.0);     // and rubbed
  }
}

/// Smooth grains that fly about, near one another.
std::vector<Grain> gas() {
  Draw draw(7);
  std::vector<Grain> grains;
  for (int k = 0; k < 125; ++k) {
    const Vec3 place = {static_cast<double>(k % 5) - 2.0, static_cast<double>(k / 5 % 5) - 2.0,
                        static_cast<double>(k / 25) - 2.0};
    grains.push_back({0.4 * half_side * place, draw.vector(0.5), {}, radius});
  }
  return grains;
}

Vec3 momentum(const Scene& scene) {
  Vec3 sum;
  for (const Grain& g : scene.grains()) sum += g.velocity;  // of equal masses
  return sum;
}

TEST(Periodic, AGasKeepsItsMomentumAndWithoutLossItsEnergy) {
  Coefficients smooth;
  smooth.restitution_pp = 1.0;
  smooth.sliding_pp = 0.0;
  smooth.rolling_pp = 0.0;
  Scene scene(cube(smooth, 2e-6), gas());
  const auto energies = [&] {
    const Simulation& s = scene.simulation();
    return measure_energies(s.comm(), {}, s.materials(), s.particles(), s.pairs(), s.walls(), s.wall_contacts());
  };
  const double before = energies().total();
  const Vec3 momentum_before = momentum(scene);
  const Vec3 first = scene.grains()[0].velocity;
  double most_elastic = 0.0;
  for (int k = 0; k < 20; ++k) {
    scene.run(500);
    const Energies e = energies();
    most_elastic = std::max(most_elastic, e.elastic);
    EXPECT_NEAR(e.total(), before, 2e-3 * before);  // of the integration at two hundred steps per impact
  }
  EXPECT_GT(most_elastic, 0.005 * before);
  EXPECT_NE(scene.grains()[0].velocity, first);
  EXPECT_EQ(inside(scene.simulation()), 125);
  // Forces are equal and opposite as integers; what remains is the rounding of 10000 kicks of 125 velocities below 1.
  EXPECT_LT(norm(momentum(scene) - momentum_before), 1e-12);
}

// A parked particle counts as outside in a domain that has no bounds along x, too: else the next one would not be seen.
TEST(Periodic, EachLeaverIsCountedAtItsStep) {
  Deck deck = bare_deck({}, 6e-6);
  deck.domain = {{-half_side, -half_side, -half_side}, {half_side, half_side, half_side}, {Axis::x, Axis::y}};
  deck.exits = {{"near_half", DomainFace::z_min, {-half_side, -half_side, 0.0}, {half_side, 0.0, 0.0}}};
  std::vector<Grain> grains;
  for (int k = 0; k < 9; ++k) {
    const double at = (k - 4) * 0.2 * half_side;
    grains.push_back({{at, -at, -0.8 * half_side + 1e-4 * k}, {3.0 - 0.9 * k, 0.5, -1.0}, {}, 0.5 * radius});
  }
  Scene scene(deck, grains);
  const Simulation& s = scene.simulation();
  for (int step = 0; step < 700; ++step) {
    scene.run(1);
    for (std::size_t i = 0; i < s.particles().owned; ++i) {
      const ParticleRecord& p = s.particles().record[i];
      EXPECT_TRUE(is_parked(p) || p.position.z >= -half_side)
          << "step " << step << ", particle " << s.particles().id[i];
    }
  }
  EXPECT_EQ(left(s), (std::vector<std::int64_t>{0, 0, 0, 0, 9, 0}));
  EXPECT_EQ(inside(s), 0);
  const ExitCount all = sum_of(s.comm(), s.left_here());
  EXPECT_GT(all.named_particles[0], 0);
  EXPECT_LT(all.named_particles[0], 9);
  EXPECT_EQ(all.named_mass[0], all.mass[4] / 9 * all.named_particles[0]);  // of equal masses
}

TEST(Periodic, TooShortADomainIsRefused) {
  const Communicator world(MPI_COMM_WORLD);
  Deck deck = chute();
  deck.domain.max.y = deck.domain.min.y + 4.9 * radius;
  deck.particles[0].max.y = deck.domain.max.y;
  deck.particles[0].count = 20;
  EXPECT_THROW(Simulation(world, deck, {}, best_vector_level()), DeckError);
  deck.domain.max.y = deck.domain.min.y + 5.1 * radius;
  const Outcome narrow = run(world, deck);
  EXPECT_EQ(narrow.inside, 20);
}

/// 20 grains of the chute, which may grow by a factor of 1.22.
Deck growing_chute() {
  Deck deck = chute();
  deck.particles[0].count = 20;
  PhaseDeck phase;
  phase.name = "grow";
  phase.until = PhaseUntil::steps;
  phase.steps = 10;
  phase.growth = {.enabled = true, .factor = 1.02, .every = 1};
  deck.phases = {phase};
  return deck;
}

std::string refusal(const Deck& deck) {
  const Communicator world(MPI_COMM_WORLD);
  try {
    const Simulation simulation(world, deck, {}, best_vector_level());
  } catch (const DeckError& error) {
    return error.what();
  }
  return "";
}

TEST(Periodic, WhatGrowsNeedsRoomToGrow) {
  Deck deck = growing_chute();
  EXPECT_EQ(refusal(deck), "");
  deck.domain.max.y = deck.domain.min.y + 5.1 * radius;
  deck.particles[0].max.y = deck.domain.max.y;
  EXPECT_NE(refusal(deck).find("less than 5 times the largest reach 0.0006095 m of a particle (with phase.growth)"),
            std::string::npos)
      << refusal(deck);
  deck = growing_chute();
  WallDeck post = floor_at(0.0);  // further from one boundary than the radius is, but not than it comes to be
  post.name = "post";
  post.type = WallType::rectangle;
  post.corner = {1.1 * radius, -0.003, 0.0};
  post.edge_u = {0.0, 0.006, 0.0};
  post.edge_v = {0.0, 0.0, 0.1};
  deck.walls.push_back(post);
  EXPECT_NE(refusal(deck).find("wall \"post\" is within a particle's radius of the periodic boundary across x"),
            std::string::npos)
      << refusal(deck);
  deck.phases[0].growth.enabled = false;
  EXPECT_EQ(refusal(deck), "");
}

TEST(Periodic, GrainsThatOverlapAcrossTheBoundaryAreRefused) {
  std::vector<Grain> grains = {{{0, 0, 0}, {}, {}, radius},
                               {{half_side - 1e-5, 0, 0}, {}, {}, radius},
                               {{-half_side + 1e-5, radius, 0}, {}, {}, radius}};
  EXPECT_THROW(Scene(cube({}, 1e-6), grains), DeckError);
  grains[2].position.y = 2.0 * radius;
  EXPECT_NO_THROW(Scene(cube({}, 1e-6), grains));
}

}  // namespace
}  // namespace repose::test
