// The whole of calibration_level_coverage_test.cpp: 200 hidden sets for each kind of cheap level, with two and three
// levels, and twenty searches.
#include <cstdio>

#include <gtest/gtest.h>

#include "calibration_level_tally.h"

namespace repose {
namespace {

// 95 % of 200 are 190, with a binomial deviation of 3.1: 181 to 199 is within three.
void expect_95_percent(const LevelStandIn& s, std::uint64_t first) {
  const int covered = covered_of(s, first, 200);
  std::printf("%zu levels: %d of 200 covered\n", s.levels(), covered);
  EXPECT_GE(covered, 181);
  EXPECT_LE(covered, 199);
}

TEST(LevelCoverage, WithALevelThatCorrelates) {
  expect_95_percent(correlated_levels(), 5000);
  expect_95_percent(with_middle(correlated_levels()), 5200);
}
TEST(LevelCoverage, WithALevelOfATrendOfItsOwn) {
  expect_95_percent(biased_levels(), 5400);
  expect_95_percent(with_middle(biased_levels()), 5600);
}
TEST(LevelCoverage, WithALevelThatIsOfNoUse) {
  expect_95_percent(useless_levels(), 5800);
  expect_95_percent(with_middle(useless_levels()), 6000);
}
// Runs of the levels above are taken to scatter as those below say, times rho: here they scatter somewhat less.
TEST(LevelCoverage, WithOneSeedAboveTheLowest) {
  expect_95_percent(with_single_seeds(correlated_levels()), 7000);
  expect_95_percent(with_single_seeds(with_middle(correlated_levels())), 7200);
}

// What limits a search is the scatter of the last level's own runs, of which the levels below cannot tell; so problems
// differ much, and the bound is of twenty of them.
TEST(LevelSearch, CostsLessThanTheLastLevelAlone) {
  constexpr int problems = 20;
  LevelStandIn s = correlated_levels();
  s.design = {20, 4};
  const SearchTally t = search_tally(s, 9400, problems, 0.2);
  std::printf("reached %d and alone %d of %d, covered %d; cost %.1f and alone %.1f runs\n", t.reached, t.reached_alone,
              problems, t.covered, t.cost, t.cost_alone);
  EXPECT_GE(t.reached, 19);
  EXPECT_GE(t.covered, 17);
  EXPECT_LT(t.cost, 0.75 * t.cost_alone);
}

}  // namespace
}  // namespace repose
