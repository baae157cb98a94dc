// What leaves the domain is counted, by face, on any number of ranks; nothing is lost.
#include <gtest/gtest.h>

#include "measurement/discharged_mass.h"
#include "scene/particles/sphere_mass.h"
#include "simulation_counts.h"
#include "support/scenes.h"

namespace repose::test {
namespace {

constexpr double radius = 1e-3;

/// Two grains leave through each face, one after the other, and three stay.
std::vector<Grain> leavers() {
  std::vector<Grain> grains = {
      {{0, 0, 0}, {}, {}, radius}, {{0.02, 0, 0}, {}, {}, radius}, {{0, 0.02, 0}, {}, {}, radius}};
  const Vec3 ways[6] = {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}};
  for (const Vec3& way : ways) {
    grains.push_back({0.049 * way, way, {}, radius});
    grains.push_back({0.044 * way, way, {}, 1.5 * radius});
  }
  return grains;
}

TEST(Exits, EveryFaceIsCountedAndNothingIsLost) {
  Deck deck = bare_deck({}, 1e-5);
  deck.domain = {{-0.05, -0.05, -0.05}, {0.05, 0.05, 0.05}};
  Scene scene(deck, leavers());
  Simulation& s = scene.simulation();
  for (int step = 0; step < 800; ++step) {
    scene.run(1);
    EXPECT_EQ(inside(s) + left_in_all(s), s.inserted()) << "step " << step;
    if (step == 300) {
      EXPECT_EQ(left(s), (std::vector<std::int64_t>(6, 1)));
    }
  }
  EXPECT_EQ(left(s), (std::vector<std::int64_t>(6, 2)));
  EXPECT_EQ(inside(s), 3);

  const double mass = sphere_mass(radius, 3592.0);
  const double each = mass * (1.0 + 1.5 * 1.5 * 1.5);
  const double unit = s.mass_unit().kilograms(1);
  // All but what has left by the top counts as discharged; rounding: half a unit for each grain, 2^-53 of the sum.
  EXPECT_NEAR(discharged_mass(s.comm(), -1.0, s.materials(), s.mass_unit(), s.particles(), s.left_here()), 5.0 * each,
              20.0 * unit + 1e-15 * each);
  EXPECT_NEAR(total_mass(s.comm(), s.materials(), s.mass_unit(), s.particles(), s.left_here()), 5.0 * each + 3.0 * mass,
              20.0 * unit + 1e-15 * each);
}

// Grains that roll off the edge of the domain on an infinite floor, which passes through the place of the parked.
TEST(Exits, RollingOffAnInfiniteFloor) {
  Deck deck = bare_deck({}, 1e-5);
  deck.gravity = {0.0, 0.0, -9.81};
  deck.domain = {{-0.05, -0.05, -0.05}, {0.05, 0.05, 0.05}};
  deck.walls.push_back(floor_at(0.0));
  std::vector<Grain> grains;
  for (int k = 0; k < 10; ++k) grains.push_back({{0.048, -0.02 + 0.004 * k, radius}, {0.5, 0, 0}, {}, radius});
  for (int k = 0; k < 10; ++k) grains.push_back({{-0.03, -0.02 + 0.004 * k, radius}, {}, {}, radius});
  Scene scene(deck, grains);
  EXPECT_NO_THROW(scene.run(1500));
  EXPECT_EQ(left(scene.simulation()), (std::vector<std::int64_t>{0, 10, 0, 0, 0, 0}));
  EXPECT_EQ(inside(scene.simulation()), 10);
}

}  // namespace
}  // namespace repose::test
