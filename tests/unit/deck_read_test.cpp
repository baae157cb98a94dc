#include <cmath>

#include <gtest/gtest.h>

#include "deck/read_deck.h"
#include "deck_example.h"

namespace repose {
namespace {

Deck read(const std::vector<std::string>& overrides = {}) { return read_deck(example_deck, "deck.toml", overrides); }

TEST(ReadDeck, FillsTheStructs) {
  const Deck deck = read();
  EXPECT_EQ(deck.domain.min, (Vec3{-0.1, -0.1, -0.1}));
  EXPECT_EQ(deck.domain.max, (Vec3{0.1, 0.1, 0.1}));
  ASSERT_EQ(deck.materials.size(), 2u);
  EXPECT_EQ(deck.materials[1].name, "steel");
  EXPECT_EQ(deck.materials[1].poisson_ratio, 0.3);
  ASSERT_EQ(deck.pairs.size(), 2u);
  EXPECT_EQ(deck.pairs[1].materials[0], "steel");
  EXPECT_EQ(deck.pairs[1].restitution, 0.8);
  ASSERT_EQ(deck.walls.size(), 3u);
  EXPECT_EQ(deck.walls[0].type, WallType::plane);
  EXPECT_EQ(deck.walls[1].points, (std::vector<std::array<double, 2>>{{0.02, 0.05}, {0.02, -0.05}}));
  EXPECT_FALSE(deck.walls[2].present);
  EXPECT_EQ(deck.walls[2].radius, 0.02);
  ASSERT_EQ(deck.particles.size(), 1u);
  EXPECT_EQ(deck.particles[0].diameter, 2e-3);
  EXPECT_EQ(deck.particles[0].count, 100);
  ASSERT_EQ(deck.phases.size(), 2u);
  EXPECT_EQ(deck.phases[0].until, PhaseUntil::kinetic_energy);
  EXPECT_EQ(deck.phases[0].add_walls, std::vector<std::string>{"gate"});
  EXPECT_EQ(deck.phases[1].time, 1.0);
}

TEST(ReadDeck, KeepsDefaultsAndResolvesDerivedOnes) {
  const Deck deck = read();
  EXPECT_EQ(deck.gravity, (Vec3{0.0, 0.0, -9.81}));
  EXPECT_EQ(deck.run.seed, 1u);
  EXPECT_EQ(deck.time.rayleigh_fraction, 0.2);
  EXPECT_TRUE(std::isnan(deck.time.expected_speed));
  EXPECT_TRUE(std::isnan(deck.particles[0].mass));
  EXPECT_EQ(deck.particles[0].spacing, 1.1 * 2e-3);
  EXPECT_EQ(deck.particles[0].radius_top, 0.015);
  EXPECT_TRUE(std::isnan(deck.phases[1].max_time));
  EXPECT_TRUE(deck.discharge.enabled);
  EXPECT_EQ(deck.angle_of_repose.max_height, 0.0);
}

TEST(ReadDeck, ThePlateIsTheDomainUnlessGiven) {
  const Deck deck = read_deck(std::string(example_deck) + "[measurement.scattering]\nplate_height = -0.05\n" +
                                  "area_1_width = 0.01\narea_3_radius = 0.08\nplate_max = [0.05, 0.06, 0]\n",
                              "deck.toml", {});
  EXPECT_TRUE(deck.scattering.enabled);
  EXPECT_EQ(deck.scattering.plate_min, (Vec3{-0.1, -0.1, -0.1}));
  EXPECT_EQ(deck.scattering.plate_max, (Vec3{0.05, 0.06, 0.0}));
  EXPECT_EQ(deck.scattering.max_height, 0.0);  // orifice_height
}

TEST(ReadDeck, MeasurementsAreOffWithoutTheirSection) {
  const std::string text = example_deck.substr(0, example_deck.find("[measurement.discharge]"));
  Deck deck = read_deck(text, "deck.toml", {});
  EXPECT_FALSE(deck.discharge.enabled);
  EXPECT_FALSE(deck.angle_of_repose.enabled);
  deck = read_deck(text + "[measurement.angle_of_repose]\nplate_height = 0\n", "deck.toml", {});
  EXPECT_TRUE(deck.angle_of_repose.enabled);
  EXPECT_EQ(deck.angle_of_repose.max_height, 0.1);  // no orifice: the top of the domain
}

TEST(ReadDeck, Overrides) {
  const Deck deck = read(
      {"time.step=2e-6", "material.0.density=3000", "material.steel.density = 7.9 g/cm3", "wall.tube.present=false",
       "pair.glass-steel.restitution=0.4", "pair.0.restitution=0.3", "measurement.discharge.plugged_share=0.3",
       "gravity=[0,0,\"-1 mm/s2\"]", "run.title=two words", "run.seed=7", "output.trace=true",
       "particles.0.diameter=440 um", "phase.flow.time=\"3 ms\"", "time.step=5 us",
       "measurement.angle_of_repose.camera=perspective", "measurement.angle_of_repose.camera_distance=0.3"});
  EXPECT_EQ(deck.time.step, 5e-6);  // the last one counts
  EXPECT_EQ(deck.materials[0].density, 3000.0);
  EXPECT_EQ(deck.materials[1].density, 7900.0);
  EXPECT_FALSE(deck.walls[1].present);
  EXPECT_EQ(deck.pairs[0].restitution, 0.3);
  EXPECT_EQ(deck.pairs[1].restitution, 0.4);
  EXPECT_EQ(deck.discharge.plugged_share, 0.3);
  EXPECT_EQ(deck.gravity, (Vec3{0.0, 0.0, -0.001}));
  EXPECT_EQ(deck.run.title, "two words");
  EXPECT_EQ(deck.run.seed, 7u);
  EXPECT_TRUE(deck.output.trace);
  EXPECT_EQ(deck.particles[0].diameter, 440e-6);
  EXPECT_EQ(deck.particles[0].spacing, 1.1 * 440e-6);
  EXPECT_EQ(deck.phases[1].time, 0.003);
  EXPECT_EQ(deck.angle_of_repose.camera, Camera::perspective);
  EXPECT_EQ(deck.angle_of_repose.camera_height, -0.05);
}

TEST(ReadDeck, AnOverrideRepairsAWrongKey) {
  std::string text = example_deck;
  text.replace(text.find("step = 1e-6"), 11, "step = \"x\"");
  EXPECT_EQ(read_deck(text, "deck.toml", {"time.step=1e-6"}).time.step, 1e-6);
}

}  // namespace
}  // namespace repose
