#include <gtest/gtest.h>

#include "base/error.h"
#include "scene/insertion/insertion.h"
#include "scene/particles/sphere_mass.h"
#include "scene_walls.h"

namespace repose {
namespace {

const std::string header = "x,y,z,vx,vy,vz,wx,wy,wz,radius,material\n";

ParticlesDeck fill_block(const Vec3& centre) {
  ParticlesDeck block;
  block.material = "grain";
  block.diameter = 0.01;
  block.mass = 0.05;
  block.centre = centre;
  block.radius = 0.05;
  block.height = 0.1;
  block.velocity = {0.0, 0.0, -0.3};
  return block;
}

ParticlesDeck csv_block(const std::string& file) {
  ParticlesDeck block;
  block.type = ParticlesType::csv;
  block.file = file;
  return block;
}

Deck deck_with(const std::vector<ParticlesDeck>& blocks) {
  Deck deck;
  deck.domain = {{-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}};
  deck.materials.resize(2);
  deck.materials[0].name = "steel";
  deck.materials[0].density = 7800.0;
  deck.materials[1].name = "grain";
  deck.materials[1].density = 1000.0;
  deck.pairs = {{{0.5, 0.5, 0.1}, {"steel", "steel"}},
                {{0.5, 0.5, 0.1}, {"steel", "grain"}},
                {{0.5, 0.5, 0.1}, {"grain", "grain"}}};
  deck.particles = blocks;
  return deck;
}

NewParticles insert(const Deck& deck, const std::string& csv = "", const std::vector<Wall>& walls = {}) {
  return insert_particles(deck, walls, [&](const std::string&) { return header + csv; }).now;
}

void expect_error(const Deck& deck, const std::string& csv, const std::string& part,
                  const std::vector<Wall>& walls = {}) {
  try {
    insert(deck, csv, walls);
    ADD_FAILURE() << "no error with: " << part;
  } catch (const DeckError& error) {
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

TEST(InsertParticles, NumbersTheBlocksOneAfterTheOther) {
  const Deck deck = deck_with({csv_block("ball.csv"), fill_block({}), fill_block({0.2, 0.0, 0.0})});
  std::string asked;
  const NewParticles particles = insert_particles(deck, {}, [&](const std::string& file) {
                                   asked = file;
                                   return header + "0,0,0.5,1,2,3,4,5,6,0.1,steel\n";
                                 }).now;
  EXPECT_EQ(asked, "ball.csv");
  const std::size_t each = 95;  // 0.05 kg of grains of 0.5236 g
  ASSERT_EQ(particles.size(), 1 + 2 * each);
  EXPECT_EQ(particles.velocity.size(), particles.size());
  EXPECT_EQ(particles.spin.size(), particles.size());
  EXPECT_EQ(particles.spin[0], (Vec3{4, 5, 6}));
  EXPECT_EQ(particles.material[0], 0);
  EXPECT_EQ(particles.material[1], 1);
  EXPECT_EQ(particles.velocity[1], (Vec3{0.0, 0.0, -0.3}));
  EXPECT_LT(particles.position[each].x, 0.05);
  EXPECT_GT(particles.position[each + 1].x, 0.15);
  double mass = 0.0;
  for (std::size_t i = 1; i <= each; ++i) mass += sphere_mass(particles.radius[i], 1000.0);
  EXPECT_NEAR(mass, 0.05, 0.5 * sphere_mass(0.005, 1000.0));
}

TEST(InsertParticles, EveryTwoMaterialsThatCanTouchNeedAPair) {
  Deck deck = deck_with({csv_block("ball.csv")});
  deck.pairs = {{{0.5, 0.5, 0.1}, {"grain", "grain"}}};
  EXPECT_EQ(insert(deck, "0,0,0,0,0,0,0,0,0,0.01,grain\n").size(), 1u);
  expect_error(deck, "0,0,0,0,0,0,0,0,0,0.01,steel\n", "no [[pair]] for \"steel\" and \"steel\"");
}

TEST(InsertParticles, RepeatsItself) {
  const Deck deck = deck_with({fill_block({}), fill_block({0.2, 0.0, 0.0})});
  EXPECT_EQ(insert(deck).position, insert(deck).position);
  Deck other = deck;
  other.run.seed = 2;
  EXPECT_NE(insert(deck).position, insert(other).position);
}

TEST(InsertParticles, BlocksMustNotMeet) {
  expect_error(deck_with({fill_block({}), fill_block({0.02, 0.0, 0.0})}), "", "must not overlap with another");
  expect_error(deck_with({fill_block({}), csv_block("ball.csv")}), "0,0,0.01,0,0,0,0,0,0,0.01,steel\n",
               "particle 95 of [[particles]] number 2 (ball.csv)");
}

TEST(InsertParticles, DeepOverlapsAreRefused) {
  const Deck deck = deck_with({csv_block("grains.csv")});
  // overlap of 0.29 and 0.31 of the smaller radius
  EXPECT_EQ(insert(deck, "0,0,0,0,0,0,0,0,0,0.1,grain\n0.1855,0,0,0,0,0,0,0,0,0.1,grain\n").size(), 2U);
  EXPECT_EQ(insert(deck, "0,0,0,0,0,0,0,0,0,0.1,grain\n0.1071,0,0,0,0,0,0,0,0,0.01,grain\n").size(), 2U);
  expect_error(deck, "0,0,0,0,0,0,0,0,0,0.1,grain\n0.1069,0,0,0,0,0,0,0,0,0.01,grain\n", "particle 0 of");
  expect_error(deck, "0,0,0,0,0,0,0,0,0,0.1,grain\n0.1069,0,0,0,0,0,0,0,0,0.01,grain\n", "particle 1 of");
}

TEST(InsertParticles, DeepWallOverlapsAreRefused) {
  const Deck deck = deck_with({csv_block("grains.csv")});
  Wall floor = plane_wall({}, {0.0, 0.0, 1.0});
  EXPECT_EQ(insert(deck, "0,0,0.071,0,0,0,0,0,0,0.1,grain\n", {floor}).size(), 1U);
  expect_error(deck, "0,0,0.069,0,0,0,0,0,0,0.1,grain\n", "into wall \"plane\"", {floor});
  floor.present = false;
  EXPECT_EQ(insert(deck, "0,0,0.069,0,0,0,0,0,0,0.1,grain\n", {floor}).size(), 1U);
}

TEST(InsertParticles, TheDomainHoldsAll) {
  expect_error(deck_with({fill_block({0.98, 0.0, 0.0})}), "", "outside the domain");
  expect_error(deck_with({csv_block("grains.csv")}), "0,0,1.5,0,0,0,0,0,0,0.1,grain\n", "particle 0 of");
}

TEST(InsertParticles, NamesTheUnknownMaterial) {
  Deck deck = deck_with({fill_block({})});
  deck.particles[0].material = "wood";
  expect_error(deck, "", "no material is named \"wood\"");
  expect_error(deck_with({csv_block("grains.csv")}), "0,0,0,0,0,0,0,0,0,0.1,wood\n", "grains.csv:2: ");
}

}  // namespace
}  // namespace repose
