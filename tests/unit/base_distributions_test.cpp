// Quantiles against published tables.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "base/distributions.h"
#include "calibration/normal_equivalent.h"

namespace repose {
namespace {

// Abramowitz and Stegun, table 26.8, six digits or less: to one of the last.
TEST(ChiSquared, QuantilesOfThePublishedTable) {
  EXPECT_NEAR(chi_squared_quantile(0.95, 1), 3.84146, 1e-5);
  EXPECT_NEAR(chi_squared_quantile(0.95, 2), 5.99147, 1e-5);
  EXPECT_NEAR(chi_squared_quantile(0.95, 3), 7.81473, 1e-5);
  EXPECT_NEAR(chi_squared_quantile(0.99, 2), 9.21034, 1e-5);
  EXPECT_NEAR(chi_squared_quantile(0.50, 1), 0.454937, 1e-6);
  EXPECT_NEAR(chi_squared_quantile(0.999, 4), 18.467, 1e-3);
  EXPECT_NEAR(chi_squared_quantile(0.05, 10), 3.94030, 1e-5);
}

TEST(ChiSquared, OfTwoDegreesIsAnExponential) {
  for (const double share : {1e-6, 0.1, 0.68, 0.999999}) {
    const double exact = -2.0 * std::log1p(-share);
    EXPECT_NEAR(chi_squared_quantile(share, 2) / exact, 1.0, 1e-10);
    EXPECT_NEAR(chi_squared_below(exact, 2), share, 1e-13);
  }
}

// The two-sided 95 % and 99 % points of Student's t (table 26.10) are those of the normal distribution.
TEST(NormalEquivalent, OfStudentsQuantiles) {
  EXPECT_NEAR(normal_equivalent(12.706, 1), 1.960, 1e-3);
  EXPECT_NEAR(normal_equivalent(4.303, 2), 1.960, 1e-3);
  EXPECT_NEAR(normal_equivalent(-3.182, 3), -1.960, 1e-3);
  EXPECT_NEAR(normal_equivalent(5.841, 3), 2.576, 1e-3);
  EXPECT_NEAR(normal_equivalent(2.571, 5), 1.960, 1e-3);
  EXPECT_NEAR(normal_equivalent(2.262, 9), 1.960, 0.002);
  EXPECT_NEAR(normal_equivalent(3.250, 9), 2.576, 0.005);
  EXPECT_NEAR(normal_equivalent(-2.086, 20), -1.960, 0.001);
  EXPECT_EQ(normal_equivalent(1.7, std::numeric_limits<double>::infinity()), 1.7);
  EXPECT_NEAR(normal_equivalent(2.0, 1e7), 2.0, 1e-5);
}

// No jumps: from the one formula to the other over the degrees of freedom, at t = 0, and far out.
TEST(NormalEquivalent, IsContinuous) {
  for (const double t : {1e-8, 0.3, 2.0, 30.0}) {
    for (const double freedom : {5.0, 6.0}) {
      EXPECT_NEAR(normal_equivalent(t, freedom - 1e-9), normal_equivalent(t, freedom + 1e-9), 1e-8)
          << t << " " << freedom;
    }
  }
  EXPECT_EQ(normal_equivalent(0.0, 2.0), 0.0);
  EXPECT_NEAR(normal_equivalent(0.9999e-7, 2.0) / normal_equivalent(1.0001e-7, 2.0), 1.0, 1e-3);
  EXPECT_LT(normal_equivalent(1e150, 1.0), normal_equivalent(1e280, 1.0));
  EXPECT_TRUE(std::isfinite(normal_equivalent(1e150, 4.0)));
}

}  // namespace
}  // namespace repose
