#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "calibration/start_design.h"
#include "calibration_stand_ins.h"

namespace repose {

/// Levels of one model in place of simulations, the cheapest first; the last one is a StandIn.
struct LevelStandIn {
  /// Of a parameter pair (sliding, rolling) and what the last level gives there.
  using Response = double (*)(double a, double b, double last);

  StandIn last;
  std::vector<std::vector<Response>> below;  ///< for each level below the last, one per observable
  std::vector<double> noise;                 ///< of each level's runs, over that of the last
  std::vector<std::size_t> design;           ///< points of each level
  std::vector<int> seeds = {};               ///< at each point of each level; empty: 2

  std::size_t levels() const { return below.size() + 1; }
};

/// Scatter of a run falls with sliding friction, to the half.
inline double scatter_factor(const StandIn& s, const std::vector<double>& point) {
  const ParameterRange& r = s.ranges[0];
  return 1.4 * std::exp2(-(point[0] - r.lower) / (r.upper - r.lower));
}

/// A small apparatus: less of everything, a bend of its own; the correlation over the box is above 0.95.
inline LevelStandIn correlated_levels() {
  return {
      .last = friction_stand_in(),
      .below = {{[](double a, double b, double last) { return 4.0 + 0.3 * last + 0.02 * std::sin(2.0 * a + b); },
                 [](double a, double b, double last) { return 6.0 + 0.7 * last + 0.5 * std::sin(2.0 * a + 3.0 * b); }}},
      .noise = {0.5, 1.0},
      .design = {36, 10}};
}

/// Coarse grains: as much a trend of their own as the response.
inline LevelStandIn biased_levels() {
  return {.last = friction_stand_in(),
          .below = {{[](double a, double b, double last) { return last + 0.8 * a - 1.2 * b; },
                     [](double a, double b, double last) { return last - 10.0 * a + 9.0 * b; }}},
          .noise = {1.0, 1.0},
          .design = {36, 10}};
}

/// Something else altogether.
inline LevelStandIn useless_levels() {
  return {.last = friction_stand_in(),
          .below = {{[](double a, double b, double) { return std::sin(6.0 * a) + std::cos(9.0 * b); },
                     [](double a, double b, double) { return 10.0 * std::cos(7.0 * a - 5.0 * b); }}},
          .noise = {1.0, 1.0},
          .design = {36, 10}};
}

/// Levels whose runs take hours but for the lowest: few points and one seed at each.
inline LevelStandIn with_single_seeds(LevelStandIn s) {
  s.design.assign(s.levels(), 5);
  s.seeds.assign(s.levels(), 1);
  s.design.front() = 14;
  s.seeds.front() = 2;
  return s;
}

/// With a level between.
inline LevelStandIn with_middle(LevelStandIn s) {
  s.below.push_back({[](double a, double b, double last) { return 2.0 + 0.6 * last + 0.05 * a * b; },
                     [](double a, double b, double last) { return 0.9 * last + 1.5 * (a - b); }});
  s.noise = {s.noise[0], 0.8, 1.0};
  s.design = {s.design[0], 16, s.design[1]};
  return s;
}

struct LevelCampaign {
  Campaign runs;
  RunLevels levels;
};

inline LevelCampaign start_of(const LevelStandIn& s, const std::vector<LaboratoryValue>& laboratory) {
  return {.runs = start_of(s.last, laboratory), .levels = {.count = s.levels(), .of_run = {}}};
}

inline void add_run(LevelCampaign& c, const LevelStandIn& s, std::size_t level, const std::vector<double>& point,
                    Draw& draw) {
  c.runs.points.push_back(point);
  c.levels.of_run.push_back(level);
  const double common = draw.normal();
  for (std::size_t k = 0; k < 2; ++k) {
    const double last = s.last.response[k](point[0], point[1]);
    const double mean = level < s.below.size() ? s.below[level][k](point[0], point[1], last) : last;
    const double scatter = s.last.seed_scatter[k] * s.noise[level] * scatter_factor(s.last, point);
    c.runs.observables[k].values.push_back(mean + scatter * (0.6 * common + 0.8 * draw.normal()));
  }
}

/// A Latin hypercube at each level.
inline void add_designs(LevelCampaign& c, const LevelStandIn& s, Draw& draw) {
  for (std::size_t level = 0; level < s.levels(); ++level) {
    const int seeds = s.seeds.empty() ? 2 : s.seeds[level];
    for (const std::vector<double>& point : start_design(s.last.ranges, s.design[level], 1)) {
      for (int k = 0; k < seeds; ++k) add_run(c, s, level, point, draw);
    }
  }
}

}  // namespace repose
