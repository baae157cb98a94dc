// Curves projected onto the components of runs: the whitening, the components and what they leave out.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "calibration/curve_components.h"
#include "calibration_curves.h"

namespace repose {
namespace {

/// Runs that differ along two shapes, without scatter.
std::vector<CurveRun> plane_of_runs(const Vector& x) {
  std::vector<CurveRun> runs;
  for (std::size_t i = 0; i < 9; ++i) {
    const double a = static_cast<double>(i % 3) - 1.0;
    const double b = static_cast<double>(i / 3) - 1.0;  // whole
    add_curve(runs, i, (3.0 + a * x.array() + 0.2 * b * x.array().square()).matrix());
  }
  return runs;
}

MeasuredCurve measured(double correlation_length) {
  MeasuredCurve curve;
  curve.x.resize(6);
  curve.x << 0.0, 0.1, 0.5, 0.9, 1.4, 2.0;
  curve.y = 3.0 + 0.3 * curve.x.array();
  curve.deviation.resize(6);
  curve.deviation << 0.1, 0.2, 0.1, 0.1, 0.3, 0.2;
  curve.correlation_length = correlation_length;
  return curve;
}

TEST(CurveComponents, KeepsWhatRunsDifferBy) {
  const MeasuredCurve curve = measured(0.7);
  const std::vector<CurveRun> runs = plane_of_runs(curve.x);
  const CurveComponents components("c", curve, runs, 1, 4);
  ASSERT_EQ(components.count(), 2);
  EXPECT_LT(components.left_out(), 1e-20);
  for (const CurveRun& run : runs) EXPECT_LT((components.curve(components.scores(run.y)) - run.y).norm(), 1e-12);
  EXPECT_LT(components.laboratory_rest(), 1e-12);
}

// The greatest value of each component is above 0, and the order of the runs, which ranks do not change but a search
// does, moves no more than the last digits.
TEST(CurveComponents, SignsAreFixed) {
  const MeasuredCurve curve = measured(0.7);
  std::vector<CurveRun> runs = plane_of_runs(curve.x);
  const CurveComponents first("c", curve, runs, 1, 4);
  for (CurveRun& run : runs) run.y = 6.0 - run.y.array();  // the mirror image of all curves
  const CurveComponents mirrored("c", curve, runs, 1, 4);
  std::reverse(runs.begin(), runs.end());
  const CurveComponents reversed("c", curve, runs, 1, 4);
  for (Index k = 0; k < 2; ++k) {
    Vector one = Vector::Zero(2);
    one[k] = 1.0;
    const Vector shape = first.curve(one) - first.curve(Vector::Zero(2));
    EXPECT_LT((mirrored.curve(one) - mirrored.curve(Vector::Zero(2)) - shape).norm(), 1e-10);
    EXPECT_LT((reversed.curve(one) - reversed.curve(Vector::Zero(2)) - shape).norm(), 1e-10);
  }
}

// Deviations with the assumed correlation have independent scores of variance 1: against the covariance in closed form.
TEST(CurveComponents, ScoresOfTheLaboratoryAreIndependent) {
  for (const double length : {0.0, 0.3, 5.0}) {
    const MeasuredCurve curve = measured(length);
    const CurveComponents components("c", curve, plane_of_runs(curve.x), 1, 4);
    Matrix covariance(6, 6);
    for (Index i = 0; i < 6; ++i) {
      for (Index j = 0; j < 6; ++j) {
        const double apart = std::fabs(curve.x[i] - curve.x[j]);
        const double correlation = length > 0.0 ? std::exp(-apart / length) : i == j ? 1.0 : 0.0;
        covariance(i, j) = curve.deviation[i] * curve.deviation[j] * correlation;
      }
    }
    Matrix slopes(2, 6);  // of the scores
    const Vector zero = components.scores(Vector::Zero(6));
    for (Index j = 0; j < 6; ++j) slopes.col(j) = components.scores(Vector::Unit(6, j)) - zero;
    EXPECT_LT((slopes * covariance * slopes.transpose() - Matrix::Identity(2, 2)).norm(), 1e-10) << length;
    EXPECT_LT((components.deviation_of(curve.deviation) - Vector::Ones(2)).norm(), 1e-10) << length;
    const Vector flat = Vector::Constant(6, 0.05);
    const Vector ratio = flat.cwiseQuotient(curve.deviation);
    const Vector expected =
        (slopes * (ratio.asDiagonal() * covariance * ratio.asDiagonal()) * slopes.transpose()).diagonal().cwiseSqrt();
    EXPECT_LT((components.deviation_of(flat) - expected).norm(), 1e-10) << length;
  }
}

// Twice as many points of the same curve say no more than the curve.
TEST(CurveComponents, NeighboursAreNotIndependent) {
  const auto spread = [](Index points, double length) {
    const Vector x = Vector::LinSpaced(points, 0.0, 1.0);
    const MeasuredCurve curve = {x, x, Vector::Constant(points, 0.1), length};
    std::vector<CurveRun> runs;
    for (std::size_t i = 0; i < 5; ++i) add_curve(runs, i, static_cast<double>(i) * (1.0 + x.array()).matrix());
    const CurveComponents components("c", curve, runs, 1, 1);
    return (components.scores(runs[4].y) - components.scores(runs[0].y))[0];
  };
  EXPECT_NEAR(spread(400, 1.0) / spread(40, 1.0), 1.0, 0.01);
  EXPECT_NEAR(spread(400, 0.0) / spread(40, 0.0), std::sqrt(10.0), 0.01);
}

TEST(CurveComponents, OnlyWhatStandsOutOfTheSeeds) {
  const Vector x = Vector::LinSpaced(20, 0.0, 1.0);
  const MeasuredCurve curve = {x, x, Vector::Constant(20, 0.1), 1.0};
  CurveDraw draw(7);
  std::vector<CurveRun> runs;
  for (std::size_t i = 0; i < 60; ++i) {
    const double a = static_cast<double>(i / 3);  // whole
    add_curve(runs, i / 3, a * x + 0.5 * draw.correlated(x, 1.0));
  }
  const CurveComponents components("c", curve, runs, 1, 4);
  EXPECT_EQ(components.count(), 1);
  EXPECT_GT(components.left_out(), 0.0);
  EXPECT_EQ(CurveComponents("c", curve, runs, 3, 4).count(), 3);
}

TEST(CurveComponents, SaysHowFarTheLaboratoryIsOff) {
  MeasuredCurve curve = measured(1.0);
  const std::vector<CurveRun> runs = plane_of_runs(curve.x);
  curve.y[2] += 5.0 * curve.deviation[2];
  const double rest = CurveComponents("c", curve, runs, 1, 4).laboratory_rest();
  EXPECT_GT(rest, 1.0);
  EXPECT_LT(rest, 5.0);
}

// A cheap level that is off by as much everywhere is no direction in which runs differ.
TEST(CurveComponents, LevelsAreEachAboutTheirOwnMean) {
  const MeasuredCurve curve = measured(1.0);
  std::vector<CurveRun> runs = plane_of_runs(curve.x);
  for (CurveRun& run : runs) run.level = 1;
  const CurveComponents last("c", curve, runs, 1, 4);
  for (CurveRun run : plane_of_runs(curve.x)) {
    run.y = run.y.array() + curve.x.array().cube();
    runs.push_back(run);
  }
  const CurveComponents both("c", curve, runs, 1, 4);
  ASSERT_EQ(both.count(), 2);
  EXPECT_LT((both.laboratory() - last.laboratory()).norm(), 1e-10);
}

TEST(CurveComponents, SameCurvesAreRefused) {
  const MeasuredCurve curve = measured(1.0);
  std::vector<CurveRun> runs = plane_of_runs(curve.x);
  for (CurveRun& run : runs) run.y = runs[0].y;
  EXPECT_THROW(CurveComponents("c", curve, runs, 1, 4), DeckError);
  EXPECT_THROW(CurveComponents("c", curve, {}, 1, 4), DeckError);
}

}  // namespace
}  // namespace repose
