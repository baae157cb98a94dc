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
  double correlation = 1.0;  ///< of the scatter of seeds and laboratory, s
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
      (s.laboratory_deviation / std::sqrt(s.repeats)).cwiseProduct(draw.correlated(s.x, s.correlation));
  return {"discharge", {s.x, laboratory, s.laboratory_deviation, s.correlation}, runs, 2, 4};
}

TEST(CurveCoverage, OfFrictionFromADischargeOverTime) {
  constexpr std::uint64_t campaigns = 200;
  constexpr int side = 6;
  constexpr int seeds = 3;
  const DischargeStandIn s;
  int covered = 0;
  int covered_by_box = 0;
  for (std::uint64_t i = 0; i < campaigns; ++i) {
    CurveDraw draw(7000 + i);
    const std::vector<double> hidden = hidden_in(s.friction, draw);
    std::vector<std::vector<double>> points;
    std::vector<CurveRun> runs;
    for (std::size_t run = 0; run < side * side * seeds; ++run) {
      const std::size_t point = run / seeds;
      const double u = static_cast<double>(point % side) / (side - 1);
      const double v = static_cast<double>(point / side) / (side - 1);  // whole over side
      points.push_back({0.1 + 0.8 * u, 0.1 + 0.4 * v});
      const Vector y = s.mean(points.back()[0], points.back()[1]);
      add_curve(runs, point, y + 0.01 * y.cwiseProduct(draw.correlated(s.x, s.correlation)));
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
    covered += misfit(at) <= chi_squared_quantile(0.95, static_cast<double>(components.count())) ? 1 : 0;
    const Vector far = at.unaryExpr([](double u) { return u < 0.5 ? u + 0.5 : u - 0.5; });
    covered_by_box += misfit(far) <= chi_squared_quantile(0.95, static_cast<double>(components.count())) ? 1 : 0;
  }
  // 95 % of 200 are 190, with a binomial deviation of 3.1: 181 to 199 is within three.
  EXPECT_GE(covered, 181);
  EXPECT_LE(covered, 199);
  EXPECT_LT(covered_by_box, 40);  // parameters that are half of the ranges away
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
