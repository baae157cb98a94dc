// Six parameters: designs that fill the space, a search, and few of the campaigns of
// calibration_six_coverage_slow_test.cpp.
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <gtest/gtest.h>

#include "base/philox.h"
#include "calibration/acquisition.h"
#include "calibration_six_stand_in.h"

namespace repose {
namespace {

double least_distance(const std::vector<std::vector<double>>& points) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t a = 0; a < points.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      double squares = 0.0;
      for (std::size_t j = 0; j < points[a].size(); ++j) squares += std::pow(points[a][j] - points[b][j], 2.0);
      least = std::min(least, std::sqrt(squares));
    }
  }
  return least;
}

// Sixty points of six dimensions: the best of 2000 hypercubes has 0.43 between its nearest two.
TEST(SixParameters, ADesignFillsTheSpace) {
  const SixStandIn s = six_stand_in();
  const auto points = start_design(s.ranges, 60, 1);
  EXPECT_GT(least_distance(points), 0.55);
  for (std::size_t j = 0; j < 6; ++j) {
    std::set<double> values;
    for (const auto& point : points) values.insert(point[j]);
    EXPECT_EQ(values.size(), 60U);  // still a hypercube
    EXPECT_EQ(*values.begin(), 0.0);
    EXPECT_EQ(*values.rbegin(), 1.0);
  }
  EXPECT_EQ(points, start_design(s.ranges, 60, 1));
}

// At least 4 of 5: fewer are less likely than 3 % at 95 %.
TEST(SixParameters, TheRegionCoversHiddenOnes) {
  const SixTally t = six_tally(six_stand_in(), 60, 2, 5, 6000);
  EXPECT_GE(t.covered, 4);
  EXPECT_GE(t.in_interval, 25);
  EXPECT_LT(t.share_of_prior, 0.6);
}

// Batches go where the parameters may be, and narrow the region more than as many points over the box.
TEST(SixParameters, NextPointsAreWhereTheParametersMayBe) {
  const SixStandIn s = six_stand_in();
  const SixCampaign c = six_campaign(s, start_design(s.ranges, 40, 1), 2, 6100);
  const Estimate e = estimate(c.misfit, 0.95);
  const auto points = next_points(c.misfit, e, 8, 2);
  ASSERT_EQ(points.size(), 8U);
  EXPECT_EQ(points, next_points(c.misfit, e, 8, 2));
  double near = 0.0;
  double all = 0.0;
  for (const std::vector<double>& point : points) {
    for (std::size_t j = 0; j < 6; ++j) {
      EXPECT_GE(point[j], 0.0);
      EXPECT_LE(point[j], 1.0);
      const Marginal& m = e.posterior->marginals[j];
      near += std::pow(point[j] - m.mean, 2.0);
      all += 1.0 / 12.0 + std::pow(0.5 - m.mean, 2.0);  // of points anywhere in the box, in the mean
    }
  }
  EXPECT_LT(near, all);
}

}  // namespace
}  // namespace repose
