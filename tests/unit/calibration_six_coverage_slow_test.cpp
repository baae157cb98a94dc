// The 95 % region of six parameters covers hidden ones in 95 % of all campaigns; so do the intervals of each alone.
#include <string>

#include <gtest/gtest.h>

#include "calibration_six_stand_in.h"

namespace repose {
namespace {

// 95 % of 200 are 190, with a binomial deviation of 3.1: 181 to 199 is within three. Of the 1200 intervals 1140, with
// a deviation of 7.5 if those of a campaign were independent; three times twice that is allowed.
void expect_95_percent(const SixTally& t) {
  EXPECT_EQ(t.campaigns, 200);
  EXPECT_GE(t.covered, 181);
  EXPECT_LE(t.covered, 199);
  EXPECT_GE(t.in_interval, 1095);
  EXPECT_LE(t.in_interval, 1185);
  EXPECT_LT(t.share_of_prior, 0.6);  // regions of all parameters would cover, too
  testing::Test::RecordProperty("covered", t.covered);
  testing::Test::RecordProperty("in_interval", t.in_interval);
  testing::Test::RecordProperty("share_of_prior", std::to_string(t.share_of_prior));
}

TEST(SixCoverage, WithUniformPriors) { expect_95_percent(six_tally(six_stand_in(), 60, 2, 200, 7000)); }

// Restitution and stiffness known from elsewhere, and one test less for each.
TEST(SixCoverage, WithMeasuredCoefficients) {
  SixStandIn s = six_stand_in();
  s.ranges[3].prior = {PriorKind::normal, 0.5, 0.1};
  s.ranges[5] = {"stiffness", 0.05, 1.5, {PriorKind::lognormal, 0.5, 0.15}};
  s.tests.erase(s.tests.begin() + 7);
  s.tests.erase(s.tests.begin() + 4);
  expect_95_percent(six_tally(s, 60, 2, 200, 8000));
}

TEST(SixCoverage, WithACurve) { expect_95_percent(six_tally(six_stand_in_with_a_curve(), 60, 2, 200, 9000)); }

}  // namespace
}  // namespace repose
