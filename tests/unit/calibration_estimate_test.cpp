// The estimate from surfaces that are known functions nearly free of noise.
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "calibration/estimate.h"
#include "calibration_samples.h"

namespace repose {
namespace {

using Function = double (*)(double, double);

const std::vector<ParameterRange> ranges = {{"mu", 0.1, 0.9}, {"mu_r", 0.0, 2.0}};

std::vector<std::vector<double>> grid_runs() {
  const Matrix grid = unit_grid(7);
  std::vector<std::vector<double>> runs;
  for (Index i = 0; i < grid.rows(); ++i) runs.push_back(from_box(ranges, grid.row(i).transpose()));
  return runs;
}

/// Functions of the parameters in units of the box.
ObservableData observable(const char* name, Function function, double laboratory, double deviation,
                          double repeats = 1) {
  return {.name = name,
          .transform = Transform::none,
          .laboratory = {.value = laboratory, .deviation = deviation, .repeats = repeats},
          .values = values_at(unit_grid(7), function)};
}

double sum(double x, double y) { return x + y; }
double difference(double x, double y) { return x - y; }
double product(double x, double y) { return (x + 0.1) * std::exp(-y); }
double bowl(double x, double y) { return (x - 0.5) * (x - 0.5) + 0.1 * y; }

// Of planes all is known: the crossing, the covariance J^-1 S J^-T, and half-widths of sqrt(limit) standard errors.
TEST(Estimate, OfTwoPlanes) {
  const std::vector<ObservableData> observables = {observable("sum", sum, 0.9, 0.06, 4.0),
                                                   observable("difference", difference, -0.1, 0.04)};
  const Estimate e = estimate(ranges, grid_runs(), observables, 0.95);
  EXPECT_NEAR(e.limit, 5.9915, 1e-4);
  ASSERT_EQ(e.points.size(), 1U);
  ASSERT_EQ(e.parts.size(), 1U);
  EXPECT_NEAR(e.points[0].values[0], 0.1 + 0.8 * 0.4, 1e-4);
  EXPECT_NEAR(e.points[0].values[1], 2.0 * 0.5, 1e-4);
  const double error = 0.5 * std::hypot(0.03, 0.04);
  EXPECT_NEAR(e.points[0].standard_errors[0] / (0.8 * error), 1.0, 1e-3);
  EXPECT_NEAR(e.points[0].standard_errors[1] / (2.0 * error), 1.0, 1e-3);
  EXPECT_NEAR(e.points[0].covariance(0, 1) / (0.25 * 1.6 * (0.03 * 0.03 - 0.04 * 0.04)), 1.0, 1e-2);
  for (std::size_t j = 0; j < 2; ++j) {
    const ConfidenceInterval& interval = e.parts[0].intervals[j];
    const double half = std::sqrt(e.limit) * e.points[0].standard_errors[j];
    EXPECT_NEAR(interval.lower, e.points[0].values[j] - half, 5e-3 * half);
    EXPECT_NEAR(interval.upper, e.points[0].values[j] + half, 5e-3 * half);
    EXPECT_FALSE(interval.open_below || interval.open_above);
  }
  EXPECT_NEAR(*e.half_width, std::sqrt(e.limit) * error, 1e-3);
  EXPECT_TRUE(e.nearest.acceptable);
  EXPECT_EQ(e.verdict, "one crossing of the laboratory's contour lines");
}

TEST(Estimate, SaysThatThereAreTwo) {
  const std::vector<ObservableData> observables = {observable("bowl", bowl, 0.14, 0.005),
                                                   observable(
                                                       "y", [](double, double y) { return y; }, 0.5, 0.02)};
  const Estimate e = estimate(ranges, grid_runs(), observables, 0.95);
  ASSERT_EQ(e.points.size(), 2U);
  ASSERT_EQ(e.parts.size(), 2U);
  EXPECT_NE(e.points[0].part, e.points[1].part);
  for (const CalibratedPoint& point : e.points) {
    EXPECT_NEAR(std::fabs(point.values[0] - 0.5), 0.8 * 0.3,
                1e-2);  // the surface's own error between points 0.17 apart
    EXPECT_NEAR(point.values[1], 1.0, 1e-3);
  }
  EXPECT_NE(e.verdict.find("2 points"), std::string::npos) << e.verdict;
}

TEST(Estimate, SaysThatThereIsNoneAndHowNearItCame) {
  std::vector<ObservableData> observables = {observable("sum", sum, 2.1, 0.05),
                                             observable("x - y", difference, 0.0, 0.05)};
  Estimate e = estimate(ranges, grid_runs(), observables, 0.95);
  EXPECT_TRUE(e.points.empty());
  EXPECT_NEAR(e.nearest.values[0], 0.9, 1e-6);
  EXPECT_NEAR(e.nearest.misfit, 4.0, 0.05);
  EXPECT_NEAR(e.nearest.off_by[0], -2.0, 0.02);
  EXPECT_TRUE(e.nearest.acceptable);
  ASSERT_EQ(e.parts.size(), 1U);
  EXPECT_TRUE(e.parts[0].intervals[0].open_above);

  observables[0].laboratory.value = 3.0;
  e = estimate(ranges, grid_runs(), observables, 0.95);
  EXPECT_FALSE(e.nearest.acceptable);
  EXPECT_TRUE(e.parts.empty());
  EXPECT_FALSE(e.half_width);
  EXPECT_NE(e.verdict.find("not acceptable"), std::string::npos) << e.verdict;
}

TEST(Estimate, OfMoreObservablesThanParametersIsTheBestFit) {
  const std::vector<ObservableData> observables = {observable("sum", sum, 1.0, 0.05),
                                                   observable("difference", difference, 0.0, 0.05),
                                                   observable(
                                                       "x", [](double x, double) { return x; }, 0.56, 0.05)};
  const Estimate e = estimate(ranges, grid_runs(), observables, 0.95);
  EXPECT_NEAR(e.limit, 7.8147, 1e-4);
  ASSERT_EQ(e.points.size(), 1U);
  // Least squares of x + y = 1, x - y = 0, x = 0.56: (2 + 1) x = 1 + 0.56.
  EXPECT_NEAR(e.points[0].values[0], 0.1 + 0.8 * 0.52, 1e-4);
  EXPECT_NEAR(e.points[0].values[1], 2.0 * 0.5, 1e-3);
  EXPECT_NEAR(e.points[0].misfit, (2 * 0.02 * 0.02 + 0.04 * 0.04) / 0.0025, 0.01);
}

TEST(Estimate, OfOneAndOfThreeParameters) {
  const std::vector<ParameterRange> one = {{"x", 0.0, 10.0}};
  std::vector<std::vector<double>> runs;
  ObservableData square = {
      .name = "square", .transform = Transform::none, .laboratory = {36.0, 2.4, 4.0}, .values = {}};
  for (int i = 0; i <= 10; ++i) {
    runs.push_back({static_cast<double>(i)});
    square.values.push_back(i * i);
  }
  const Estimate line = estimate(one, runs, std::vector{square}, 0.95);
  ASSERT_EQ(line.points.size(), 1U);
  EXPECT_NEAR(line.points[0].values[0], 6.0, 1e-3);
  EXPECT_NEAR(line.parts[0].intervals[0].lower, std::sqrt(36.0 - 1.95996 * 1.2), 2e-3);
  EXPECT_NEAR(line.parts[0].intervals[0].upper, std::sqrt(36.0 + 1.95996 * 1.2), 2e-3);

  const std::vector<ParameterRange> three = {{"a", 0.0, 1.0}, {"b", 0.0, 1.0}, {"c", 0.0, 1.0}};
  std::vector<ObservableData> each(3);
  for (std::size_t k = 0; k < 3; ++k)
    each[k] = {.name = "p", .transform = {}, .laboratory = {0.5, 0.02, 1.0}, .values = {}};
  runs.clear();
  for (int i = 0; i < 27; ++i) {
    runs.push_back({0.5 * (i % 3), 0.5 * (i / 3 % 3), 0.5 * (i / 9)});
    for (std::size_t k = 0; k < 3; ++k) each[k].values.push_back(runs.back()[k]);
  }
  const Estimate volume = estimate(three, runs, each, 0.95);
  ASSERT_EQ(volume.points.size(), 1U);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(volume.points[0].values[k], 0.5, 1e-6);
    EXPECT_NEAR(volume.parts[0].intervals[k].upper, 0.5 + 0.02 * std::sqrt(7.8147), 1e-3);
  }
}

TEST(Estimate, ADeviationOfFewRepeatsIsLessCertain) {
  std::vector<ObservableData> observables = {observable("sum", sum, 0.9, 0.06, 4.0),
                                             observable("difference", difference, -0.1, 0.04)};
  const Misfit known(ranges, grid_runs(), observables);
  observables[0].laboratory.freedom = 3.0;
  const Misfit estimated(ranges, grid_runs(), observables);
  // At a t of 3.182 with 3 degrees of freedom, z is 1.96.
  const Vector at = vector_of({0.4 + 0.5 * 3.182 * 0.03, 0.5 + 0.5 * 3.182 * 0.03});
  EXPECT_NEAR(known(at), 3.182 * 3.182, 0.01);
  EXPECT_NEAR(estimated(at), 1.96 * 1.96, 0.05);
}

/// The message with which an estimate is refused.
std::string refusal(const std::vector<ObservableData>& observables, double confidence = 0.95) {
  try {
    estimate(ranges, grid_runs(), observables, confidence);
  } catch (const DeckError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Estimate, RefusesWhatItCannotTell) {
  const ObservableData plane = observable("sum", sum, 0.9, 0.06);
  EXPECT_NE(refusal({plane}).find("1 observables for 2 parameters"), std::string::npos) << refusal({plane});
  EXPECT_NE(refusal({plane, plane}, 1.0).find("confidence"), std::string::npos);
  ObservableData broken = plane;
  broken.values.pop_back();
  EXPECT_NE(refusal({plane, broken}).find("48 values for 49 runs"), std::string::npos);
  broken = plane;
  broken.laboratory.deviation = -1.0;
  EXPECT_NE(refusal({plane, broken}).find("deviation"), std::string::npos);
  broken = plane;
  broken.values.assign(49, std::numeric_limits<double>::quiet_NaN());
  EXPECT_NE(refusal({plane, broken}).find("at 0 points"), std::string::npos);
  const std::vector<ParameterRange> four(4, {"p", 0.0, 1.0});
  EXPECT_THROW(estimate(four, std::vector<std::vector<double>>(49, {0, 0, 0, 0}), std::vector(4, plane), 0.95),
               DeckError);
  const std::vector<ParameterRange> narrow = {{"mu", 0.5, 0.5}, {"mu_r", 0.0, 1.0}};
  EXPECT_THROW(estimate(narrow, grid_runs(), std::vector{plane, plane}, 0.95), DeckError);
}

// (x + 0.1) e^-y on x + y = 0.9.
TEST(Estimate, OfALaboratoryWithoutErrorIsNearlyAPoint) {
  const std::vector<ObservableData> observables = {observable("sum", sum, 0.9, 0.0),
                                                   observable("product", product, 0.5 * std::exp(-0.5), 0.0)};
  const Estimate e = estimate(ranges, grid_runs(), observables, 0.95);
  ASSERT_EQ(e.points.size(), 1U);
  EXPECT_NEAR(e.points[0].values[0], 0.1 + 0.8 * 0.4, 1e-3);
  ASSERT_EQ(e.parts.size(), 1U);
  EXPECT_LT(e.parts[0].intervals[0].upper - e.parts[0].intervals[0].lower, 0.02);
}

TEST(Estimate, AnObservableThatIsTheSameEverywhereTellsNothing) {
  const auto flat = [](double, double) { return 3.0; };
  std::vector<ObservableData> observables = {observable("sum", sum, 0.9, 0.02), observable("flat", flat, 3.0, 0.1)};
  Estimate e = estimate(ranges, grid_runs(), observables, 0.95);
  ASSERT_EQ(e.parts.size(), 1U);
  EXPECT_TRUE(e.parts[0].intervals[0].open_below);
  EXPECT_LE(e.points.size(), 1U);
  EXPECT_NE(e.verdict.find("do not tell mu, mu_r"), std::string::npos) << e.verdict;
  observables[1].laboratory.value = 4.0;
  e = estimate(ranges, grid_runs(), observables, 0.95);
  EXPECT_TRUE(e.points.empty());
  EXPECT_FALSE(e.nearest.acceptable);
}

// Two observables that say the same cannot tell two parameters apart: the region goes from edge to edge.
TEST(Estimate, OfOneObservableTwiceIsABand) {
  const std::vector<ObservableData> observables = {observable("sum", sum, 1.0, 0.02),
                                                   observable("again", sum, 1.0, 0.02)};
  const Estimate e = estimate(ranges, grid_runs(), observables, 0.95);
  ASSERT_EQ(e.parts.size(), 1U);
  EXPECT_TRUE(e.parts[0].intervals[0].open_below);
  EXPECT_TRUE(e.parts[0].intervals[0].open_above);
  EXPECT_NEAR(*e.half_width, 0.5, 1e-6);
  EXPECT_EQ(e.points.size(), 1U);
}

}  // namespace
}  // namespace repose
