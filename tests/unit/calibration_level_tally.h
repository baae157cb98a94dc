#pragma once

#include <algorithm>
#include <optional>

#include "base/distributions.h"
#include "calibration/acquisition.h"
#include "calibration/estimate.h"
#include "calibration_level_stand_ins.h"

namespace repose {

/// Of so many campaigns, each with hidden parameters, a laboratory and runs of its own, those whose 95 % region has the
/// hidden parameters.
inline int covered_of(const LevelStandIn& s, std::uint64_t first, std::uint64_t campaigns) {
  const double limit = chi_squared_quantile(0.95, 2);
  int covered = 0;
  for (std::uint64_t i = 0; i < campaigns; ++i) {
    Draw draw(first + i);
    const std::vector<double> hidden = hidden_in(s.last, draw);
    LevelCampaign c = start_of(s, laboratory_of(s.last, hidden, draw));
    add_designs(c, s, draw);
    const Misfit misfit(s.last.ranges, c.runs.points, c.levels, c.runs.observables);
    covered += misfit(to_box(s.last.ranges, hidden)) <= limit ? 1 : 0;
  }
  return covered;
}

/// Only the last level of a stand-in.
inline LevelStandIn last_alone(LevelStandIn s) {
  s.below.clear();
  s.noise = {s.noise.back()};
  s.design = {9};
  return s;
}

struct SearchOutcome {
  double cost = 0.0;  ///< runs of the last level, and of those below by their cost
  bool reached = false;
  bool covered = false;
};

/// Batches of four points with two seeds, until the half-width is that asked for in two estimates in a row or the
/// budget is spent. A run of a level costs a twentieth of one of the next.
inline SearchOutcome search_levels(const LevelStandIn& s, const std::vector<LaboratoryValue>& laboratory,
                                   const std::vector<double>& hidden, double half_width, double budget, Draw& draw) {
  constexpr std::size_t seeds = 2;
  const auto cost_of = [&](std::size_t level) {
    return std::pow(20.0, static_cast<double>(level + 1) - static_cast<double>(s.levels()));
  };
  LevelCampaign c = start_of(s, laboratory);
  add_designs(c, s, draw);
  SearchOutcome outcome;
  for (std::size_t level : c.levels.of_run) outcome.cost += cost_of(level);
  bool narrow = false;
  while (true) {
    const Misfit misfit(s.last.ranges, c.runs.points, c.levels, c.runs.observables);
    const Estimate now = estimate(misfit, 0.95);
    const bool narrow_before = narrow;
    narrow = now.half_width && *now.half_width <= half_width;
    outcome.reached = narrow && narrow_before;
    outcome.covered = misfit(to_box(s.last.ranges, hidden)) <= now.limit;
    BatchPlan batch;
    batch.points = 4;
    batch.seeds.assign(s.levels(), seeds);
    batch.cost = [&](const LevelPoint& p) { return static_cast<double>(seeds) * cost_of(p.level); };
    batch.budget = budget - outcome.cost;
    const std::vector<LevelPoint> next =
        outcome.reached ? std::vector<LevelPoint>{} : next_level_points(misfit, now, batch);
    if (next.empty()) return outcome;
    for (const LevelPoint& p : next) {
      for (std::size_t k = 0; k < seeds; ++k) add_run(c, s, p.level, p.values, draw);
      outcome.cost += batch.cost(p);
    }
  }
}

/// Of problems with hidden parameters away from the edges: what searches over levels and on the last one alone take for
/// the same half-width.
struct SearchTally {
  double cost = 0.0, cost_alone = 0.0;  ///< in the mean
  int reached = 0, reached_alone = 0, covered = 0;
};

inline SearchTally search_tally(const LevelStandIn& levels, std::uint64_t first, int problems, double half_width) {
  constexpr double budget = 150.0;
  SearchTally t;
  const LevelStandIn alone = last_alone(levels);
  for (int i = 0; i < problems; ++i) {
    Draw draw(first + static_cast<std::uint64_t>(i));
    const std::vector<double> hidden = {draw.between(0.55, 0.85), draw.between(0.2, 0.4)};
    const std::vector<LaboratoryValue> laboratory = laboratory_of(levels.last, hidden, draw);
    const SearchOutcome whole = search_levels(levels, laboratory, hidden, half_width, budget, draw);
    const SearchOutcome single = search_levels(alone, laboratory, hidden, half_width, budget, draw);
    t.cost += whole.cost / problems;
    t.cost_alone += single.cost / problems;
    t.reached += whole.reached ? 1 : 0;
    t.reached_alone += single.reached ? 1 : 0;
    t.covered += whole.covered ? 1 : 0;
  }
  return t;
}

}  // namespace repose
