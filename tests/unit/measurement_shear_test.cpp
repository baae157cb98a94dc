// The stresses in the plane of a shear cell from the loads on the walls of one half.
#include <cmath>

#include <gtest/gtest.h>

#include "base/math.h"
#include "measurement/shear_stress.h"

namespace repose {
namespace {

ShearDeck box() {
  ShearDeck deck;
  deck.direction = {2.0, 0.0, 0.0};
  deck.area = 0.02;
  return deck;
}

ShearDeck ring() {
  ShearDeck deck;
  deck.type = ShearType::rotation;
  deck.axis_origin = {0.1, -0.2, 0.3};
  deck.axis_direction = {0.0, 0.0, 3.0};
  deck.inner_radius = 0.05;
  deck.outer_radius = 0.1;
  return deck;
}

TEST(ShearStress, TheWallsBelowBearTheWeightOfTheirGrainsToo) {
  const ShearStress stress = shear_stress(box(), {{-4.0, 1.0, -9.0}, {}}, {0.0, 0.0, -1.0}, {0.0, 0.0, -0.5});
  EXPECT_DOUBLE_EQ(stress.shear, -200.0);
  EXPECT_DOUBLE_EQ(stress.normal, 400.0);
}

TEST(ShearStress, BelowTheWallsAboveThePlaneBearsTheWeightOfTheirGrainsToo) {
  const ShearStress stress = shear_stress(box(), {{4.0, 0.0, 9.0}, {}}, {0.0, 0.0, -1.0}, {0.0, 0.0, -0.5});
  EXPECT_DOUBLE_EQ(stress.shear, 200.0);
  EXPECT_DOUBLE_EQ(stress.normal, 475.0);
}

TEST(ShearStress, AnInclinedWeightIsNoShear) {
  const Vec3 below = {0.3, 0.0, -1.0}, above = {0.15, 0.0, -0.5};
  const ShearStress bed = shear_stress(box(), {below, {}}, below, above);  // of grains that lie below the plane alone
  EXPECT_DOUBLE_EQ(bed.shear, 0.0);
  EXPECT_DOUBLE_EQ(bed.normal, 0.0);
  EXPECT_DOUBLE_EQ(shear_stress(box(), {{4.0, 0.0, 9.0}, {}}, below, above).shear, (4.0 - 0.15) / 0.02);
}

/// The same stress everywhere on a ring, summed over small patches, whatever the axis.
TEST(ShearStress, OfARingIsThatOfItsPatches) {
  const ShearDeck deck = ring();
  constexpr double shear = 300.0, normal = 700.0;
  constexpr int rings = 400, sectors = 360;
  WallLoad load;
  for (int i = 0; i < rings; ++i) {
    const double width = (deck.outer_radius - deck.inner_radius) / rings;
    const double r = deck.inner_radius + (i + 0.5) * width;
    for (int k = 0; k < sectors; ++k) {
      const double angle = 2.0 * pi * k / sectors, area = r * width * 2.0 * pi / sectors;
      const Vec3 outwards = {std::cos(angle), std::sin(angle), 0.0}, around = {-std::sin(angle), std::cos(angle), 0.0};
      const Vec3 force = (shear * area) * around + Vec3{0.0, 0.0, normal * area};
      load.force += force;
      load.torque += cross(deck.axis_origin + r * outwards, force);
    }
  }
  const ShearStress stress = shear_stress(deck, load, {}, {});
  EXPECT_NEAR(stress.shear, shear, 1e-5 * shear);
  EXPECT_NEAR(stress.normal, normal, 1e-9 * normal);
  EXPECT_NEAR(shear_area(deck), pi * 0.0075, 1e-15);
}

}  // namespace
}  // namespace repose
