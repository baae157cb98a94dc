// Neighbour lists, ghosts and owners of a whole simulation miss no contact, whoever holds what.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "simulation_counts.h"
#include "support/draw.h"
#include "support/scenes.h"

namespace repose::test {
namespace {

constexpr int rows = 8;

/// Rows in which a grain at 0.5 m/s hits one at rest, which then hits a third, 0.7 radii further on; far away grains at
/// 2 m/s hit nothing. On several ranks the two groups are on different ones, with a wide gap between them and the plane
/// that divides the ranks, which is among some more at rest. `gap` m before the first collision.
std::vector<Grain> cradles_and_travellers(double gap) {
  std::vector<Grain> grains;
  const double r = 2.2e-4;
  for (int k = 0; k < rows; ++k) {
    const double y = 0.002 * k;
    grains.push_back({{-2.0 * r - gap, y, 0.0}, {0.5, 0.0, 0.0}, {}, r});
    grains.push_back({{0.0, y, 0.0}, {}, {}, r});
    grains.push_back({{2.7 * r, y, 0.0}, {}, {}, r});
  }
  for (int k = 0; k < 3 * rows; ++k) grains.push_back({{5.0, 0.002 * k, 0.0}, {2.0, 0.0, 0.0}, {}, r});
  for (int k = 0; k < rows; ++k) grains.push_back({{2.0 + 0.1 * k, 0.0, 0.0}, {}, {}, r});
  return grains;
}

Coefficients elastic() {
  Coefficients c;
  c.youngs_modulus = 1e7;
  c.restitution_pp = 1.0;
  return c;
}

// While the travellers use up their inner skins every few steps, and new inner lists are made for all, the grains of
// the other rank must not get further than their outer skins unseen.
TEST(Lists, NoContactIsMissedBesideFasterGrainsElsewhere) {
  for (int phase = 0; phase < 10; ++phase) {  // of the first collision, between two rebuilds
    Scene scene(bare_deck(elastic(), 4e-6), cradles_and_travellers(2e-5 + 3e-5 * phase));
    scene.run(400);
    const std::vector<Grain> grains = scene.grains();
    for (std::size_t row = 0; row < rows; ++row) {
      // Equal elastic grains hand on their speed; what is lost to the discrete steps is far below 6 %.
      EXPECT_NEAR(grains[3 * row + 1].velocity.x, 0.0, 0.03) << "row " << row << ", phase " << phase;
      EXPECT_NEAR(grains[3 * row + 2].velocity.x, 0.5, 0.03) << "row " << row << ", phase " << phase;
    }
  }
}

TEST(Lists, SameBitsAsWithListsOfEverything) {
  Deck everything = bare_deck(elastic(), 4e-6);
  everything.neighbours.skin = 10.0;
  everything.neighbours.inner_skin = 5.0;
  std::int64_t renewed = 0;
  for (int phase = 0; phase < 10; ++phase) {
    const std::vector<Grain> grains = cradles_and_travellers(2e-5 + 3e-5 * phase);
    Scene usual(bare_deck(elastic(), 4e-6), grains);
    Scene wide(everything, grains);
    usual.run(400);
    wide.run(400);
    EXPECT_EQ(hash_of(usual.simulation()), hash_of(wide.simulation())) << "phase " << phase;
    renewed += usual.simulation().comm().sum(usual.simulation().counters().outer_renewals);
  }
  if (Communicator(MPI_COMM_WORLD).size() <= 2) {  // more divide the rows
    EXPECT_GT(renewed, 50);
  }
}

/// Grains with radii from 0.3 to 3 mm, one in ten of them fast, in a box with two walls and four open sides.
Deck mixed_deck() {
  Deck deck = bare_deck({}, 4e-6);
  deck.gravity = {2.0, 1.0, -9.0};
  deck.domain = {{-0.02, -0.02, -0.02}, {0.08, 0.08, 0.08}};
  deck.time.expected_speed = 3.0;
  deck.walls.push_back(floor_at(-0.005));
  WallDeck side = floor_at(0.0);
  side.name = "side";
  side.point = {0.05, 0.0, 0.0};
  side.normal = {-1.0, 0.2, 0.1};
  deck.walls.push_back(side);
  ParticlesDeck list;
  list.type = ParticlesType::csv;
  list.file = "grains.csv";
  deck.particles.push_back(list);
  return deck;
}

std::string mixed_grains() {
  Draw draw(91);
  std::string csv = "x,y,z,vx,vy,vz,wx,wy,wz,radius,material\n";
  for (int k = 0; k < 216; ++k) {
    const double r = k % 12 == 0 ? draw(2e-3, 3e-3) : draw(3e-4, 6e-4);
    const double free = 3e-3 - r;  // in a cell of 6 mm
    const Vec3 x = Vec3{6e-3 * (k % 6), 6e-3 * (k / 6 % 6), 6e-3 * (k / 36)} + draw.vector(free);
    const Vec3 v = draw.vector(k % 10 == 0 ? 2.0 : 0.3);
    const Vec3 w = draw.vector(50.0);
    csv += fmt::format("{},{},{},{},{},{},{},{},{},{},grain\n", x.x, x.y, x.z, v.x, v.y, v.z, w.x, w.y, w.z, r);
  }
  return csv;
}

TEST(MixedSizes, SameBitsAsOnOneRank) {
  const Communicator world(MPI_COMM_WORLD);
  const Communicator self(MPI_COMM_SELF);
  const std::string csv = mixed_grains();
  const auto read = [&](const std::string&) { return csv; };
  const Deck deck = mixed_deck();
  Simulation together(world, deck, read, best_vector_level());
  std::vector<std::string> hashes;
  for (int part = 0; part < 5; ++part) {
    for (int step = 0; step < 2000; ++step) together.step();
    together.check_guards();
    hashes.push_back(hash_of(together));
  }
  EXPECT_GT(left_in_all(together), 5);
  EXPECT_GT(inside(together), 50);
  if (world.is_root()) {
    Simulation alone(self, deck, read, best_vector_level());
    for (int part = 0; part < 5; ++part) {
      for (int step = 0; step < 2000; ++step) alone.step();
      alone.check_guards();
      EXPECT_EQ(hash_of(alone), hashes[static_cast<std::size_t>(part)]) << "part " << part;
      if (part > 0) {
        EXPECT_NE(hashes[static_cast<std::size_t>(part)], hashes[static_cast<std::size_t>(part) - 1]);
      }
    }
  }
  world.barrier();
}

}  // namespace
}  // namespace repose::test
