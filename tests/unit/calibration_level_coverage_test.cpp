// The 95 % region of the last level covers hidden parameters in 95 % of all campaigns, whatever the level below is worth.
#include <cmath>
#include <cstdio>
#include <vector>

#include <gtest/gtest.h>

#include "base/distributions.h"
#include "calibration/estimate.h"
#include "calibration_level_stand_ins.h"

namespace repose {
namespace {

struct Tally {
  int covered = 0;
  double half_width = 0.0;  ///< in the mean
};

Tally tally(const LevelStandIn& s, std::uint64_t first, std::uint64_t campaigns, std::uint64_t stride) {
  Tally result;
  const double limit = chi_squared_quantile(0.95, 2);
  double widths = 0.0;
  double alone = 0.0;
  int alone_covered = 0;
  for (std::uint64_t i = 0; i < campaigns; ++i) {
    Draw draw(first + i);
    const std::vector<double> hidden = hidden_in(s.last, draw);
    LevelCampaign c = start_of(s, laboratory_of(s.last, hidden, draw));
    add_designs(c, s, 2, draw);
    const Misfit misfit(s.last.ranges, c.runs.points, c.levels, c.runs.observables);
    result.covered += misfit(to_box(s.last.ranges, hidden)) <= limit ? 1 : 0;
    Campaign last;
    last.observables = c.runs.observables;
    for (auto& o : last.observables) o.values.clear();
    for (std::size_t r = 0; r < c.runs.points.size(); ++r) {
      if (c.levels.of_run[r] + 1 != c.levels.count) continue;
      last.points.push_back(c.runs.points[r]);
      for (std::size_t k = 0; k < 2; ++k) last.observables[k].values.push_back(c.runs.observables[k].values[r]);
    }
    const Misfit plain(s.last.ranges, last.points, last.observables);
    alone_covered += plain(to_box(s.last.ranges, hidden)) <= limit ? 1 : 0;
    if (i % stride != 0) continue;
    widths += 1.0;
    result.half_width += estimate(misfit, 0.95).half_width.value_or(0.0);
    alone += estimate(plain, 0.95).half_width.value_or(0.0);
  }
  result.half_width /= widths;
  std::printf("covered %d of %d, half-width %.4f; last level alone %d, %.4f\n", result.covered,
              static_cast<int>(campaigns), result.half_width, alone_covered, alone / widths);
  return result;
}

TEST(LevelCoverage, Correlated) { tally(correlated_levels(), 3000, 200, 10); }
TEST(LevelCoverage, Biased) { tally(biased_levels(), 3000, 200, 10); }
TEST(LevelCoverage, Useless) { tally(useless_levels(), 3000, 200, 10); }
TEST(LevelCoverage, Correlated3) { tally(with_middle(correlated_levels()), 3000, 200, 10); }
TEST(LevelCoverage, Useless3) { tally(with_middle(useless_levels()), 3000, 200, 10); }

}  // namespace
}  // namespace repose
