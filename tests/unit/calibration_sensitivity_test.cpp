// One at a time, Morris screening, start design.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "calibration/morris.h"
#include "calibration/one_at_a_time.h"
#include "calibration/start_design.h"

namespace repose {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

TEST(OneAtATime, EffectWithTheScatterOfItsSeeds) {
  const OneAtATimeEffect e = one_at_a_time_effect(std::vector{1.0, 2.0, 3.0, none}, std::vector{6.0, 8.0});
  EXPECT_EQ(e.lower.runs, 3.0);
  EXPECT_NEAR(e.lower.deviation, 1.0, 1e-15);
  EXPECT_NEAR(e.effect, 5.0, 1e-15);
  EXPECT_NEAR(e.standard_error, std::sqrt(1.0 / 3.0 + 2.0 / 2.0), 1e-15);
  const OneAtATimeEffect single = one_at_a_time_effect(std::vector{1.0}, std::vector{6.0});
  EXPECT_EQ(single.effect, 5.0);
  EXPECT_TRUE(std::isnan(single.standard_error));
  EXPECT_TRUE(std::isnan(one_at_a_time_effect(std::vector{none}, std::vector{6.0}).effect));
}

const std::vector<ParameterRange> unit(5, {"p", 0.0, 1.0});

TEST(Morris, TrajectoriesMoveEachParameterOnce) {
  const auto points = morris_design(unit, 30, 4, 7);
  ASSERT_EQ(points.size(), 180U);
  EXPECT_EQ(points, morris_design(unit, 30, 4, 7));
  EXPECT_NE(points, morris_design(unit, 30, 4, 8));
  std::array<int, 4> at_level = {};
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (const double x : points[i]) {
      const double level = 3.0 * x;
      ASSERT_NEAR(level, std::round(level), 1e-12);
      ++at_level[static_cast<std::size_t>(std::lround(level))];
    }
    if (i % 6 == 0) continue;
    int moved = 0;
    for (std::size_t j = 0; j < 5; ++j) {
      const double step = std::fabs(points[i][j] - points[i - 1][j]);
      if (step == 0.0) continue;
      EXPECT_NEAR(step, 2.0 / 3.0, 1e-12);
      ++moved;
    }
    EXPECT_EQ(moved, 1);
  }
  for (const int count : at_level) EXPECT_NEAR(count, 225, 60);  // of 900; all levels are equally likely
}

TEST(Morris, OfALinearFunctionIsItsSlopes) {
  const std::vector<ParameterRange> ranges = {{"a", 0.0, 10.0}, {"b", -1.0, 1.0}, {"c", 2.0, 3.0}};
  const auto points = morris_design(ranges, 6, 4, 1);
  std::vector<double> values;
  for (const auto& p : points) values.push_back(3.0 * p[0] - 2.0 * p[1] + 7.0);
  const std::vector<MorrisEffect> effects = morris_effects(ranges, points, values);
  const double slopes[] = {30.0, -4.0, 0.0};
  for (std::size_t j = 0; j < 3; ++j) {
    EXPECT_NEAR(effects[j].mean, slopes[j], 1e-12);
    EXPECT_NEAR(effects[j].mean_absolute, std::fabs(slopes[j]), 1e-12);
    EXPECT_NEAR(effects[j].deviation, 0.0, 1e-12);
    EXPECT_EQ(effects[j].effects, 6.0);
  }
}

// Sobol's g function, the product of (|4 x - 2| + a) / (1 + a) (Campolongo 2007): with 4 levels and steps of 2/3 each
// factor goes by 4/3 either way or not at all (|4 x - 2| is 2, 2/3, 2/3, 2 at the levels), so an effect is
// +-(4/3) / (2/3) / (1 + a) times the other factors: mu = 0, and mu* = 2 / (1 + a) x the mean of the others, of which
// each is (4/3 + a) / (1 + a).
TEST(Morris, OfSobolsGFunction) {
  const double a[] = {0.0, 1.0, 4.5, 9.0, 99.0};
  constexpr std::size_t trajectories = 4000;
  const auto points = morris_design(unit, trajectories, 4, 3);
  std::vector<double> values;
  for (const auto& p : points) {
    double product = 1.0;
    for (std::size_t j = 0; j < 5; ++j) product *= (std::fabs(4.0 * p[j] - 2.0) + a[j]) / (1.0 + a[j]);
    values.push_back(product);
  }
  const std::vector<MorrisEffect> effects = morris_effects(unit, points, values);
  for (std::size_t j = 0; j < 5; ++j) {
    double expected = 2.0 / (1.0 + a[j]);
    for (std::size_t k = 0; k < 5; ++k) expected *= k == j ? 1.0 : (4.0 / 3.0 + a[k]) / (1.0 + a[k]);
    EXPECT_NEAR(effects[j].mean_absolute, expected, 4.0 * effects[j].mean_absolute_error);
    EXPECT_NEAR(effects[j].mean, 0.0, 4.0 * effects[j].mean_error);
    EXPECT_LT(effects[j].mean_absolute_error, 0.02 * expected);
  }
}

TEST(Morris, LeavesOutEffectsWithoutAValue) {
  const auto points = morris_design(unit, 2, 4, 1);
  std::vector<double> values(points.size(), 1.0);
  values[0] = none;
  double effects = 0.0;
  for (const MorrisEffect& e : morris_effects(unit, points, values)) effects += e.effects;
  EXPECT_EQ(effects, 9.0);
}

TEST(Morris, RefusesOddLevels) {
  EXPECT_THROW(morris_design(unit, 4, 3, 1), DeckError);
  EXPECT_THROW(morris_design(unit, 0, 4, 1), DeckError);
  EXPECT_THROW(morris_effects(unit, morris_design(unit, 2, 4, 1), std::vector{1.0}), DeckError);
}

// Into the gaps: a point of a grid that is left out is nearly found again.
TEST(StartDesign, PointsBetweenFillTheSpace) {
  const std::vector<ParameterRange> ranges = {{"a", 0.0, 2.0}, {"b", 10.0, 11.0}};
  std::vector<std::vector<double>> known;
  for (int k = 0; k < 25; ++k) {
    if (k != 12) known.push_back({0.5 * (k % 5), 10.0 + 0.25 * (k / 5)});
  }
  const auto points = points_between(ranges, known, 2, 1);
  ASSERT_EQ(points.size(), 2U);
  EXPECT_NEAR(points[0][0], 1.0, 0.1);
  EXPECT_NEAR(points[0][1], 10.5, 0.05);
  EXPECT_GT(std::hypot(0.5 * (points[1][0] - points[0][0]), points[1][1] - points[0][1]), 0.1);
  EXPECT_EQ(points, points_between(ranges, known, 2, 1));
  EXPECT_TRUE(points_between(ranges, known, 0, 1).empty());
}

TEST(StartDesign, ShowsEachParameterAtAsManyValuesAsPoints) {
  const std::vector<ParameterRange> ranges = {{"a", 0.1, 0.9}, {"b", 10.0, 17.0}};
  const auto points = start_design(ranges, 8, 1);
  EXPECT_EQ(points, start_design(ranges, 8, 1));
  ASSERT_EQ(points.size(), 8U);
  for (std::size_t j = 0; j < 2; ++j) {
    std::vector<double> values;
    for (const auto& point : points) values.push_back(point[j]);
    std::sort(values.begin(), values.end());
    for (std::size_t i = 0; i < 8; ++i) {
      EXPECT_NEAR(values[i], ranges[j].lower + (ranges[j].upper - ranges[j].lower) * static_cast<double>(i) / 7.0,
                  1e-12);
    }
  }
  // The best hypercubes of 8 points are sqrt(5) steps apart at least.
  double least = 1.0;
  for (std::size_t i = 0; i < 8; ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      least = std::min(least, std::hypot((points[i][0] - points[k][0]) / 0.8, (points[i][1] - points[k][1]) / 7.0));
    }
  }
  EXPECT_GT(least, std::sqrt(5.0) / 7.0 - 1e-9);
  EXPECT_EQ(start_design(ranges, 1, 1).front(), (std::vector{0.5, 13.5}));
  EXPECT_THROW(start_design(ranges, 0, 1), DeckError);
}

}  // namespace
}  // namespace repose
