#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <gtest/gtest.h>

#include "base/error.h"
#include "measurement/angle_of_repose.h"
#include "measurement/pile.h"
#include "measurement_piles.h"

namespace repose {
namespace {

constexpr double everything = std::numeric_limits<double>::infinity();

AngleOfRepose measure(const std::vector<Sphere>& grains, const AngleOfReposeParameters& parameters = {}) {
  const auto result = angle_of_repose(find_pile(grains, parameters.plate_height, everything), parameters);
  if (!result) throw std::runtime_error("no pile found");
  return *result;
}

TEST(Silhouette, OfOneGrainIsItsCircle) {
  const std::vector<Sphere> grain{{{1.0, 2.0, 3.0}, 0.5}};
  const Silhouette s = silhouette(project(grain, {.axis = {1.0, 0.0, 0.0}}), 2.0, 0.1);
  ASSERT_EQ(s.left.size(), 15u);
  EXPECT_DOUBLE_EQ(s.top, 3.5);
  for (std::size_t row = 0; row < s.left.size(); ++row) {
    const double dz = s.row_z(row) - 3.0;
    if (std::abs(dz) > 0.5) {
      EXPECT_TRUE(std::isnan(s.left[row]) && std::isnan(s.right[row])) << row;
    } else {
      EXPECT_NEAR(s.right[row], std::sqrt(0.25 - dz * dz), 1e-12) << row;
      EXPECT_NEAR(s.left[row], -std::sqrt(0.25 - dz * dz), 1e-12) << row;
    }
  }
}

TEST(Silhouette, TurnsWithTheCamera) {
  const std::vector<Sphere> grain{{{3.0, 1.0, 0.0}, 0.5}};
  const auto u = [&](double azimuth) { return project(grain, {.azimuth = azimuth})[0].u; };
  EXPECT_NEAR(u(0.0), 3.0, 1e-12);
  EXPECT_NEAR(u(0.5 * pi), 1.0, 1e-12);
  EXPECT_NEAR(u(pi), -3.0, 1e-12);
}

TEST(Silhouette, PinholeEnlargesWhatIsNear) {
  const std::vector<Sphere> grains{{{1.0, -5.0, 3.0}, 0.5}, {{1.0, 10.0, 3.0}, 0.5}};
  const std::vector<Disc> discs = project(grains, {.camera_distance = 10.0, .camera_height = 1.0});
  EXPECT_NEAR(discs[0].u, 2.0, 1e-12);
  EXPECT_NEAR(discs[0].z, 5.0, 1e-12);
  EXPECT_NEAR(discs[0].radius, 1.0, 1e-12);
  EXPECT_NEAR(discs[1].u, 0.5, 1e-12);
  EXPECT_NEAR(discs[1].z, 2.0, 1e-12);
  EXPECT_NEAR(discs[1].radius, 0.25, 1e-12);
  EXPECT_THROW(project(grains, {.camera_distance = 5.4}), DeckError);
}

class Cone : public testing::TestWithParam<double> {};

/// 0.5 degree is what the measurement promises; the skin of these cones misses the cone
/// by less than a tenth of a diameter.
TEST_P(Cone, IsMeasuredLeftAndRight) {
  for (const std::size_t azimuths : {std::size_t{1}, std::size_t{36}}) {
    const AngleOfRepose result = measure(test::cone(5e-3, GetParam()), {.azimuths = azimuths});
    EXPECT_NEAR(result.left_deg, GetParam(), 0.5);
    EXPECT_NEAR(result.right_deg, GetParam(), 0.5);
    EXPECT_NEAR(result.mean_deg, 0.5 * (result.left_deg + result.right_deg), 1e-12);
    EXPECT_EQ(result.views.size(), azimuths);
    EXPECT_NEAR(result.pile_height, 5e-3, test::diameter);
  }
}

TEST_P(Cone, IsMeasuredAmongStraysAndAirborneGrains) {
  const std::vector<Sphere> cone = test::cone(5e-3, GetParam());
  std::vector<Sphere> grains = cone;
  const double foot = 5e-3 / std::tan(GetParam() * degree);
  test::add_strays(grains, 50, foot, foot + 6e-3, 11);
  test::add_airborne(grains, 20, 20e-3, foot, 12);
  const AngleOfRepose result = measure(grains);
  EXPECT_NEAR(result.left_deg, GetParam(), 0.5);
  EXPECT_NEAR(result.right_deg, GetParam(), 0.5);
  EXPECT_NEAR(result.mean_deg, measure(cone).mean_deg, 1e-9);
}

TEST_P(Cone, IsMeasuredOffTheAxisAndOnARaisedPlate) {
  std::vector<Sphere> grains = test::cone(5e-3, GetParam());
  for (Sphere& s : grains) s.centre += Vec3{0.1, -0.2, -0.04};
  const AngleOfRepose result = measure(grains, {.plate_height = -0.04, .axis = {0.1, -0.2, 0.0}});
  EXPECT_NEAR(result.mean_deg, measure(test::cone(5e-3, GetParam())).mean_deg, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Angles, Cone, testing::Values(20.0, 30.0, 40.0));

/// A lattice cut by a cone has terraces, and near its tip fewer grains reach the outline: it may look flatter, by less
/// than 0.5 degree in the mean of four orientations.
TEST(AngleOfRepose, OfARoughConeIsThatOfTheConeAroundIt) {
  for (const double angle : {20.0, 30.0, 40.0}) {
    double mean = 0.0;
    for (const unsigned seed : {1u, 2u, 3u, 4u}) mean += 0.25 * measure(test::rough_cone(5e-3, angle, seed)).mean_deg;
    EXPECT_NEAR(mean, angle, 0.5);
  }
}

TEST(AngleOfRepose, TellsLeftFromRight) {
  const auto slope = [](double x) { return std::tan((x < 0.0 ? 25.0 : 35.0) * degree); };
  std::vector<Sphere> grains = test::heap(5e-3, slope);
  const double foot = 5e-3 / slope(-1.0);
  test::add_strays(grains, 50, foot, foot + 6e-3, 21);
  test::add_airborne(grains, 20, 20e-3, foot, 22);
  const AngleOfRepose result = measure(grains, {.azimuths = 1});
  EXPECT_NEAR(result.left_deg, 25.0, 0.5);
  EXPECT_NEAR(result.right_deg, 35.0, 0.5);
  EXPECT_NEAR(result.mean_deg, 30.0, 0.5);
  EXPECT_TRUE(std::isnan(result.stderr_deg));

  const AngleOfRepose around = measure(grains);
  EXPECT_LT(around.left_deg, around.right_deg);
  EXPECT_GT(around.stderr_deg, 0.0);
  EXPECT_LT(around.independent_views, 20.0);  // the angle changes slowly with the azimuth
}

/// Piles that differ by grains strewn over them at random, of which each view's outline has its few. The scatter of 40
/// is known to 11 %; views taken for independent would give less than half of it.
TEST(AngleOfRepose, StandardErrorIsTheScatterFromPileToPile) {
  const std::vector<Sphere> cone = test::cone(5e-3, 30.0);
  constexpr unsigned piles = 40;
  std::vector<double> angles;
  double error_squared = 0.0;
  for (unsigned seed = 1; seed <= piles; ++seed) {
    std::vector<Sphere> grains = cone;
    test::strew(grains, 100, 5e-3, 30.0, seed);
    const AngleOfRepose result = measure(grains);
    angles.push_back(result.mean_deg);
    error_squared += result.stderr_deg * result.stderr_deg / piles;
  }
  const double mean = std::accumulate(angles.begin(), angles.end(), 0.0) / piles;
  double variance = 0.0;
  for (const double angle : angles) variance += (angle - mean) * (angle - mean) / (piles - 1);
  EXPECT_NEAR(std::sqrt(error_squared / variance), 1.0, 0.33);
}

TEST(AngleOfRepose, ViewsAreEvenOverTheHalfTurnThatKeepsLeftLeft) {
  for (const std::size_t n : {std::size_t{1}, std::size_t{4}, std::size_t{5}}) {
    std::vector<double> azimuths;
    for (const FlankView& view : measure(test::cone(2e-3, 30.0), {.azimuths = n}).views)
      azimuths.push_back(view.azimuth);
    EXPECT_EQ(azimuths.front(), 0.0);
    std::sort(azimuths.begin(), azimuths.end());
    EXPECT_GE(azimuths.front(), -0.5 * pi);
    EXPECT_LE(azimuths.back(), 0.5 * pi);
    for (std::size_t i = 1; i < n; ++i) {
      EXPECT_NEAR(azimuths[i] - azimuths[i - 1], pi / static_cast<double>(n), 1e-12);
    }
  }
}

TEST(AngleOfRepose, OfMixedSizes) {
  const std::vector<Sphere> grains = test::cone(5e-3, 30.0, 0.5 * test::diameter);
  const AngleOfRepose result = measure(grains);
  EXPECT_EQ(result.pile_grains, grains.size());
  EXPECT_NEAR(result.left_deg, 30.0, 0.5);
  EXPECT_NEAR(result.right_deg, 30.0, 0.5);
}

/// From 10 m the images of the grains of this pile move by less than 1e-3 of their distance from the axis.
TEST(AngleOfRepose, FromAFarCameraIsThatOfAnOrthographicView) {
  const std::vector<Sphere> grains = test::cone(5e-3, 30.0);
  const AngleOfRepose near = measure(grains, {.camera_distance = 0.05, .camera_height = 0.03});
  const AngleOfRepose far = measure(grains, {.camera_distance = 10.0, .camera_height = 2.5e-3});
  const double orthographic = measure(grains).mean_deg;
  EXPECT_NEAR(far.mean_deg, orthographic, 0.01);
  EXPECT_GT(std::abs(near.mean_deg - orthographic), 0.2);
}

TEST(AngleOfRepose, IsAbsentWithoutAPile) { EXPECT_FALSE(angle_of_repose({}, {}).has_value()); }

TEST(AngleOfRepose, RefusesHeightsThatEncloseNoFlank) {
  const std::vector<Sphere> grains = test::cone(5e-3, 30.0);
  EXPECT_THROW(measure(grains, {.fit_from = 0.5, .fit_to = 0.5}), DeckError);
}

}  // namespace
}  // namespace repose
