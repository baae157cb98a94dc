// A curve in place of two figures: the 95 % region covers hidden parameters in 95 % of all campaigns.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "base/distributions.h"
#include "calibration/curve_components.h"
#include "calibration/estimate.h"
#include "calibration_curves.h"

namespace repose {
namespace {

/// A discharge: mass in g over time in s.
struct DischargeStandIn {
  StandIn friction = friction_stand_in();
  Vector x = Vector::LinSpaced(30, 0.1, 3.0);
  double of_seeds = 1.0;       ///< lengths of the correlation, s: of runs with other seeds,
  double of_laboratory = 1.0;  ///< of the laboratory's errors,
  double assumed = 1.0;        ///< and what is said of these
  Vector laboratory_deviation = Vector::LinSpaced(30, 0.2, 0.6);
  double repeats = 10.0;

  Vector mean(double sliding, double rolling) const {
    const double mass = friction.response[0](sliding, rolling);
    const double rate = 2.2 - 1.1 * std::tanh(sliding / 0.4) - 0.5 * rolling * sliding;
    return mass * (1.0 - (-rate * x.array()).exp());
  }
};

CurveComponents components_of(const DischargeStandIn& s, const std::vector<double>& hidden,
                              const std::vector<CurveRun>& runs, CurveDraw& draw) {
  const Vector laboratory =
      s.mean(hidden[0], hidden[1]) +
      (s.laboratory_deviation / std::sqrt(s.repeats)).cwiseProduct(draw.correlated(s.x, s.of_laboratory));
  return {"discharge", {s.x, laboratory, s.laboratory_deviation, s.assumed}, runs, 2, 4};
}

/// How many of the campaigns' regions have the hidden parameters, and how many have others.
struct Covered {
  int hidden = 0;
  int others = 0;  ///< half of the ranges away
};

constexpr std::uint64_t campaigns = 200;

Covered covered(const DischargeStandIn& s, std::uint64_t first) {
  constexpr int side = 6;
  constexpr int seeds = 3;
  Covered result;
  for (std::uint64_t i = 0; i < campaigns; ++i) {
    CurveDraw draw(first + i);
    const std::vector<double> hidden = hidden_in(s.friction, draw);
    std::vector<std::vector<double>> points;
    std::vector<CurveRun> runs;
    for (std::size_t run = 0; run < side * side * seeds; ++run) {
      const std::size_t point = run / seeds;
      const double u = static_cast<double>(point % side) / (side - 1);
      const double v = static_cast<double>(point / side) / (side - 1);  // whole over side
      points.push_back({0.1 + 0.8 * u, 0.1 + 0.4 * v});
      const Vector y = s.mean(points.back()[0], points.back()[1]);
      add_curve(runs, point, y + 0.01 * y.cwiseProduct(draw.correlated(s.x, s.of_seeds)));
    }
    const CurveComponents components = components_of(s, hidden, runs, draw);
    std::vector<ObservableData> observables;
    for (Index k = 0; k < components.count(); ++k) {
      ObservableData& o = observables.emplace_back();
      o.name = std::to_string(k);
      o.laboratory = {components.laboratory()[k], 1.0, s.repeats};
      for (const CurveRun& run : runs) o.values.push_back(components.scores(run.y)[k]);
    }
    const Misfit misfit(s.friction.ranges, points, observables);
    const Vector at = to_box(s.friction.ranges, hidden);
    result.hidden += misfit(at) <= chi_squared_quantile(0.95, static_cast<double>(components.count())) ? 1 : 0;
    const Vector far = at.unaryExpr([](double u) { return u < 0.5 ? u + 0.5 : u - 0.5; });
    result.others += misfit(far) <= chi_squared_quantile(0.95, static_cast<double>(components.count())) ? 1 : 0;
  }
  return result;
}

// 95 % of 200 are 190, with a binomial deviation of 3.1: 181 to 199 is within three.
void expect_95_percent(const Covered& c) {
  EXPECT_GE(c.hidden, 181);
  EXPECT_LE(c.hidden, 199);
  EXPECT_LT(c.others, 40);
}

TEST(CurveCoverage, OfFrictionFromADischargeOverTime) { expect_95_percent(covered({}, 7000)); }
TEST(CurveCoverage, WhereSeedsScatterMoreRoughly) { expect_95_percent(covered({.of_seeds = 0.1}, 8000)); }
TEST(CurveCoverage, OfIndependentErrors) { expect_95_percent(covered({.of_laboratory = 1e-9, .assumed = 0.0}, 9000)); }

// Errors that are taken for more alike than they are make the region too wide rather than too narrow.
TEST(CurveCoverage, RougherErrorsThanAssumed) {
  for (const double length : {1e-9, 0.2})
    EXPECT_GE(covered({.of_laboratory = length, .assumed = 2.9}, 10000).hidden, 186);
}

// A curve against itself: the laboratory has the curve of runs at known parameters, and these are found.
TEST(CurveCoverage, ACurveAgainstItselfGivesTheTruth) {
  const DischargeStandIn s;
  const std::vector<double> truth = {0.42, 0.31};
  std::vector<std::vector<double>> points;
  std::vector<CurveRun> runs;
  for (std::size_t point = 0; point < 64; ++point) {
    points.push_back(
        {0.1 + 0.8 * static_cast<double>(point % 8) / 7.0, 0.1 + 0.4 * static_cast<double>(point / 8) / 7.0});  // whole
    add_curve(runs, point, s.mean(points.back()[0], points.back()[1]));
  }
  const MeasuredCurve curve = {s.x, s.mean(truth[0], truth[1]), Vector::Constant(s.x.size(), 1e-3), 3.0};
  const CurveComponents components("discharge", curve, runs, 2, 4);
  std::vector<ObservableData> observables;
  for (Index k = 0; k < components.count(); ++k) {
    ObservableData& o = observables.emplace_back();
    o.name = std::to_string(k);
    o.laboratory = {components.laboratory()[k], 1.0};
    for (const CurveRun& run : runs) o.values.push_back(components.scores(run.y)[k]);
  }
  const Estimate e = estimate(s.friction.ranges, points, observables, 0.95);
  ASSERT_EQ(e.points.size(), 1U) << e.verdict;
  EXPECT_NEAR(e.points[0].values[0], truth[0], 0.01);
  EXPECT_NEAR(e.points[0].values[1], truth[1], 0.01);
  EXPECT_LT(e.half_width.value_or(1.0), 0.1);
}

}  // namespace
}  // namespace repose
