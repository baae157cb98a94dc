// Slope of a bed in a drum, the avalanche that ends its rise, and the extrapolated onset of motion.
#include <cmath>

#include <gtest/gtest.h>

#include "base/math.h"
#include "measurement/avalanche.h"
#include "measurement/surface_angle.h"
#include "measurement/tilt_onset.h"

namespace repose {
namespace {

constexpr double radius = 0.5e-3;
constexpr Vec3 down = {0.0, 0.0, -9.81};

SurfaceAngleDeck drum() {
  SurfaceAngleDeck deck;
  deck.axis_origin = {0.01, 0.0, 0.02};
  deck.radius = 0.03;
  return deck;
}

/// Touching rows of grains along y below a plane that rises by `angle` (rad) along x, inside the drum.
std::vector<Sphere> bed(double angle) {
  std::vector<Sphere> grains;
  const Vec3 along = {std::cos(angle), 0.0, std::sin(angle)};
  const Vec3 below = {std::sin(angle), 0.0, -std::cos(angle)};
  for (int i = -29; i <= 29; ++i) {
    for (int k = 5; k < 29; ++k) {
      const Vec3 from_axis = (2.0 * radius * i) * along + (2.0 * radius * k) * below;
      if (norm(from_axis) > 0.03 - radius) continue;
      for (int j = -2; j <= 2; ++j)
        grains.push_back({drum().axis_origin + from_axis + Vec3{0.0, 2.0 * radius * j, 0.0}, radius});
    }
  }
  return grains;
}

TEST(SurfaceAngle, OfAPlaneBed) {
  for (const double degrees : {-35.0, -10.0, 0.0, 25.0}) {
    const auto angle = surface_angle(drum(), down, bed(degrees * pi / 180.0));
    ASSERT_TRUE(angle);
    EXPECT_NEAR(*angle * 180.0 / pi, degrees, 1.0);  // columns are two grains wide
  }
}

TEST(SurfaceAngle, GrainsThatFlyDoNotCount) {
  std::vector<Sphere> grains = bed(0.4);
  const auto without = surface_angle(drum(), down, grains);
  for (int k = 0; k < 10; ++k)
    grains.push_back({drum().axis_origin + Vec3{1e-3 * k, 0.0, 0.02 - 1.5e-3 * (k % 2)}, radius});
  EXPECT_EQ(surface_angle(drum(), down, grains), without);
}

TEST(SurfaceAngle, NoneWithoutABedOrWithoutGravityAcross) {
  EXPECT_FALSE(surface_angle(drum(), down, {}));
  EXPECT_FALSE(surface_angle(drum(), down, std::vector<Sphere>{{{0.01, 0.0, 0.0}, radius}}));
  EXPECT_FALSE(surface_angle(drum(), {0.0, -9.81, 0.0}, bed(0.2)));
}

TEST(TiltOnset, ExtrapolatesAwayWhatGrowsWithTheRateToTwoThirds) {
  const auto seen = [](double rate) { return 0.127 + 0.02 * std::pow(rate, 2.0 / 3.0); };
  EXPECT_NEAR(extrapolated_onset(seen(0.3), seen(0.15), 0.5), 0.127, 1e-15);
}

TEST(SurfaceAngle, AtRestIsThatOfWholeColumns) {
  std::vector<Sphere> grains = bed(0.2);
  const auto whole = surface_angle_at_rest(drum(), down, grains);
  ASSERT_TRUE(whole);
  EXPECT_NEAR(*whole, 0.2, 0.01);
  // 15 mm is seven and a half columns; of the last one the grains of the surface are taken away.
  std::erase_if(grains, [](const Sphere& g) {
    const Vec3 from_axis = g.centre - drum().axis_origin;
    return from_axis.x > 0.0141 && from_axis.x * std::sin(-0.2) + from_axis.z * std::cos(0.2) > -8.5e-3;
  });
  EXPECT_EQ(surface_angle_at_rest(drum(), down, grains), whole);
  EXPECT_GT(std::fabs(*surface_angle(drum(), down, grains) - *whole), 0.02);
  EXPECT_FALSE(surface_angle_at_rest(drum(), down, {}));
}

TEST(Avalanche, IsTheFirstFallOfTheSlopeByMoreThanTwoDegrees) {
  Avalanche avalanche;
  for (int k = 0; k <= 30;
       ++k) {  // the bed creeps, and a grain that gives way makes the surface less steep for a while
    const double tilt = 1.0 * k;
    avalanche.add((tilt - 0.02 * k - (k == 20 ? 2.9 : 0.0)) * degree, tilt * degree);
    EXPECT_FALSE(avalanche.seen()) << k;
  }
  avalanche.add(27.6 * degree, 31.0 * degree);
  EXPECT_FALSE(avalanche.seen());
  avalanche.add(27.3 * degree, 31.1 * degree);
  EXPECT_TRUE(avalanche.seen());
  avalanche.add(35.0 * degree, 40.0 * degree);  // a later one does not count
  EXPECT_NEAR(avalanche.slope() / degree, 29.4, 1e-12);
  EXPECT_NEAR(avalanche.tilt() / degree, 30.0, 1e-12);
}

}  // namespace
}  // namespace repose
