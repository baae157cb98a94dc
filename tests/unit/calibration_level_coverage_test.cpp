// The 95 % region of the last level holds the hidden parameters whatever the levels below are worth, and a search over
// levels costs less than one on the last level alone. As much of it as half a minute allows;
// calibration_level_coverage_slow_test.cpp has the whole.
#include <gtest/gtest.h>

#include "calibration_level_tally.h"

namespace repose {
namespace {

// 95 % of 50 are 47.5, with a binomial deviation of 1.5: 42 has a chance of 0.3 %.
void expect_coverage(const LevelStandIn& s) { EXPECT_GE(covered_of(s, 5000, 50), 42); }

TEST(LevelCoverage, WithALevelThatCorrelates) { expect_coverage(correlated_levels()); }
TEST(LevelCoverage, WithALevelOfATrendOfItsOwn) { expect_coverage(biased_levels()); }
TEST(LevelCoverage, WithALevelThatIsOfNoUse) { expect_coverage(useless_levels()); }
TEST(LevelCoverage, WithOneSeedAboveTheLowest) { expect_coverage(with_single_seeds(correlated_levels())); }

TEST(LevelSearch, CostsLessThanTheLastLevelAlone) {
  LevelStandIn s = correlated_levels();
  s.design = {36, 4};
  const SearchTally t = search_tally(s, 6000, 2, 0.2);
  EXPECT_EQ(t.reached, 2);
  EXPECT_LT(t.cost, 0.8 * t.cost_alone);
}

}  // namespace
}  // namespace repose
