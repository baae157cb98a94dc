#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "calibration/estimate.h"
#include "calibration/posterior.h"
#include "calibration/start_design.h"
#include "calibration_curves.h"

namespace repose {

/// Eight observables of a laboratory's tests over six parameters, in place of simulations: sliding and rolling
/// friction, friction at walls, restitution, cohesion and stiffness, each in units of its range.
struct SixStandIn {
  using Response = double (*)(const std::vector<double>& p);
  struct Test {
    const char* name;
    Response response;
    double seed_scatter;          ///< of one run
    double laboratory_deviation;  ///< of one measurement
  };

  /// A test that gives a curve.
  struct Curve {
    Vector (*response)(const Vector& x, const std::vector<double>& p);
    Vector x;
    double seed_scatter;  ///< of one run, as a share
    Vector laboratory_deviation;
    double correlation_length;  ///< of both
  };

  std::vector<ParameterRange> ranges;
  std::vector<Test> tests;
  std::optional<Curve> curve;
  double repeats = 5.0;
};

inline SixStandIn six_stand_in() {
  using P = const std::vector<double>&;
  SixStandIn s;
  for (const char* name : {"sliding", "rolling", "wall", "restitution", "cohesion", "stiffness"}) {
    s.ranges.push_back({name, 0.0, 1.0});
  }
  s.tests = {
      {"discharge",
       [](P p) {
         return 23.0 - 0.8 * std::tanh(3.0 * p[0]) - 1.8 * p[1] * rise((p[0] - 0.3) / 0.15) - 0.5 * p[2] -
                0.9 * p[4] * p[4];
       },
       0.05, 0.08},
      {"heap",
       [](P p) {
         return 16.0 + 9.0 * std::tanh(2.5 * p[0]) + 10.0 * p[1] * rise((p[0] - 0.25) / 0.15) + 4.0 * p[4] - 1.5 * p[3];
       },
       0.5, 0.9},
      {"drum",
       [](P p) { return 20.0 + 8.0 * std::tanh(2.0 * p[0]) + 5.0 * p[1] + 9.0 * p[4] * (0.4 + p[0]) - 2.0 * p[3]; },
       0.4, 0.8},
      {"drawdown", [](P p) { return 30.0 + 5.0 * p[0] + 9.0 * p[1] * p[1] + 5.0 * p[2] + 3.0 * p[4]; }, 0.4, 0.8},
      {"scatter", [](P p) { return 5.0 + 20.0 * p[3] * p[3] * (1.0 - 0.3 * p[2]) + 6.0 * p[3]; }, 0.6, 1.0},
      {"shear", [](P p) { return 10.0 + 12.0 * std::tanh(1.5 * p[0]) + 3.0 * p[1] + 8.0 * p[4]; }, 0.3, 0.6},
      {"wall shear", [](P p) { return 5.0 + 20.0 * std::pow(0.1 + p[2], 1.3) + p[0]; }, 0.5, 0.8},
      {"compression", [](P p) { return 10.0 + 7.0 * std::cbrt(0.1 + p[5]) - p[0] + 0.5 * p[1]; }, 0.15, 0.25}};
  return s;
}

/// The same tests, but the discharge and the drawdown are one curve, the mass (g) over time (s): how much comes, how
/// soon, and how it slows down.
inline SixStandIn six_stand_in_with_a_curve() {
  SixStandIn s = six_stand_in();
  s.tests.erase(s.tests.begin() + 3);
  s.tests.erase(s.tests.begin());
  const auto drained = [](const Vector& x, const std::vector<double>& p) -> Vector {
    const double mass = 23.0 - 0.8 * std::tanh(3.0 * p[0]) - 1.8 * p[1] - 0.9 * p[4] * p[4];
    const double rate = 2.2 - 1.1 * std::tanh(1.5 * p[0]) - 0.6 * p[2] - 0.3 * p[4];
    const double slowing = 1.0 + 0.5 * p[1] * p[0];
    return mass * (1.0 - (-rate * x.array().pow(slowing)).exp());
  };
  s.curve = {drained, Vector::LinSpaced(30, 0.1, 3.0), 0.01, Vector::LinSpaced(30, 0.15, 0.4), 1.0};
  return s;
}

/// Adds the observables that a curve is made into. `runs` has the parameters of each, points with `seeds` one after the
/// other.
inline void add_curve_observables(const SixStandIn& s, const std::vector<double>& hidden,
                                  const std::vector<std::vector<double>>& runs, std::size_t seeds, CurveDraw& draw,
                                  std::vector<ObservableData>& observables) {
  const SixStandIn::Curve& c = *s.curve;
  const Vector laboratory =
      c.response(c.x, hidden) +
      (c.laboratory_deviation / std::sqrt(s.repeats)).cwiseProduct(draw.correlated(c.x, c.correlation_length));
  std::vector<CurveRun> curves;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const Vector y = c.response(c.x, runs[i]);
    add_curve(curves, i / seeds, y + c.seed_scatter * y.cwiseProduct(draw.correlated(c.x, c.correlation_length)));
  }
  const CurveComponents components("drained", {c.x, laboratory, c.laboratory_deviation, c.correlation_length}, curves,
                                   4, 4);
  for (Index k = 0; k < components.count(); ++k) {
    ObservableData& o = observables.emplace_back();
    o.name = "drained." + std::to_string(k + 1);
    o.laboratory = {components.laboratory()[k], 1.0, s.repeats};
    for (const CurveRun& run : curves) o.values.push_back(components.scores(run.y)[k]);
  }
}

/// A laboratory with hidden parameters, and the posterior from runs at a design that fills the space.
struct SixCampaign {
  Misfit misfit;
  std::vector<double> hidden;
};

inline SixCampaign six_campaign(const SixStandIn& s, const std::vector<std::vector<double>>& design, int seeds,
                                std::uint64_t seed) {
  CurveDraw draw(seed);
  std::vector<double> hidden;
  for (const ParameterRange& range : s.ranges) hidden.push_back(prior_quantile(range, draw.between(0.0, 1.0)));
  std::vector<ObservableData> observables;
  for (const SixStandIn::Test& t : s.tests) {
    const double error = t.laboratory_deviation / std::sqrt(s.repeats);
    observables.push_back({.name = t.name,
                           .transform = Transform::none,
                           .laboratory = {.value = t.response(hidden) + error * draw.normal(),
                                          .deviation = t.laboratory_deviation,
                                          .repeats = s.repeats},
                           .values = {}});
  }
  std::vector<std::vector<double>> runs;
  for (const std::vector<double>& point : design) {
    for (int k = 0; k < seeds; ++k) {
      runs.push_back(point);
      const double common = draw.normal();  // what the seed does to all
      for (std::size_t t = 0; t < s.tests.size(); ++t) {
        observables[t].values.push_back(s.tests[t].response(point) +
                                        s.tests[t].seed_scatter * (0.5 * common + std::sqrt(0.75) * draw.normal()));
      }
    }
  }
  if (s.curve) add_curve_observables(s, hidden, runs, static_cast<std::size_t>(seeds), draw, observables);
  return {Misfit(s.ranges, runs, observables), hidden};
}

/// How often the regions of campaigns hold what is hidden.
struct SixTally {
  int campaigns = 0;
  int covered = 0;              ///< by the region of all parameters together
  int in_interval = 0;          ///< parameters in their own interval
  double share_of_prior = 0.0;  ///< of the posterior's deviations over the prior's, in the mean
};

inline SixTally six_tally(const SixStandIn& s, int points, int seeds, int campaigns, std::uint64_t first) {
  const std::vector<std::vector<double>> design = start_design(s.ranges, static_cast<std::size_t>(points), 1);
  constexpr SamplePlan plan = {.walkers = 300};  // enough for a share, and a third of the time
  SixTally t;
  for (int i = 0; i < campaigns; ++i, ++t.campaigns) {
    const SixCampaign c = six_campaign(s, design, seeds, first + static_cast<std::uint64_t>(i));
    const Posterior posterior = posterior_of(c.misfit, 0.95, plan);
    t.covered += posterior.covers(log_posterior(c.misfit, to_box(s.ranges, c.hidden))) ? 1 : 0;
    for (std::size_t j = 0; j < c.hidden.size(); ++j) {
      const Marginal& m = posterior.marginals[j];
      t.in_interval += m.interval.lower <= c.hidden[j] && c.hidden[j] <= m.interval.upper ? 1 : 0;
      t.share_of_prior += m.deviation / m.prior_deviation / (6.0 * campaigns);
    }
  }
  return t;
}

}  // namespace repose
