// Fixed-point contributions to force sums: rounding, range and independence of the order.
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "support/draw.h"
#include "support/fixed_point_sum.h"

namespace repose::test {
namespace {

std::int64_t rounded(double value, double scale = 1.0) {
  std::int64_t sum = 0;
  EXPECT_TRUE(add_fixed_point(to_fixed_point(value, scale), sum)) << value;
  return sum;
}

/// What does not fit must leave the sum as it was.
bool fits(double value) {
  std::int64_t sum = 7;
  const bool added = add_fixed_point(to_fixed_point(value, 1.0), sum);
  EXPECT_EQ(sum != 7, added);
  return added;
}

TEST(FixedPoint, RoundsToTheNearestTiesToEven) {
  EXPECT_EQ(rounded(0.0), 0);
  EXPECT_EQ(rounded(-0.0), 0);
  EXPECT_EQ(rounded(0.49), 0);
  EXPECT_EQ(rounded(0.51), 1);
  EXPECT_EQ(rounded(-0.51), -1);
  EXPECT_EQ(rounded(0.5), 0);
  EXPECT_EQ(rounded(1.5), 2);
  EXPECT_EQ(rounded(2.5), 2);
  EXPECT_EQ(rounded(-2.5), -2);
  EXPECT_EQ(rounded(-3.5), -4);
  EXPECT_EQ(rounded(0.75, 4.0), 3);
  EXPECT_EQ(rounded(1e-300, 0x1p+40), 0);
}

TEST(FixedPoint, IsOddInItsArgument) {
  Draw draw(4);
  for (int k = 0; k < 10000; ++k) {
    const double value = std::ldexp(draw(-1.0, 1.0), static_cast<int>(draw(0.0, 51.0)));
    EXPECT_EQ(rounded(value), -rounded(-value));
    EXPECT_EQ(static_cast<double>(rounded(value)), std::nearbyint(value));
  }
}

TEST(FixedPoint, SeesWhatIsOutOfRange) {
  constexpr double half = 0x1p+51;
  EXPECT_TRUE(fits(half - 1.0));
  EXPECT_TRUE(fits(-half + 1.0));
  EXPECT_FALSE(fits(half));
  EXPECT_FALSE(fits(-half - 1.0));
  for (const double value : {2.0 * half, 4.0 * half, 6.0 * half, 1e100, 1e308}) {
    EXPECT_FALSE(fits(value)) << value;
    EXPECT_FALSE(fits(-value)) << value;
  }
}

TEST(FixedPoint, SeesNanAndInfinity) {
  EXPECT_FALSE(fits(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_FALSE(fits(-std::numeric_limits<double>::quiet_NaN()));
  EXPECT_FALSE(fits(std::numeric_limits<double>::infinity()));
  EXPECT_FALSE(fits(-std::numeric_limits<double>::infinity()));
}

TEST(FixedPoint, AThousandGreatestContributionsDoNotWrap) {
  std::int64_t sum = 0;
  bool in_range = true;
  for (int k = 0; k < 1000; ++k) in_range &= add_fixed_point(to_fixed_point(0x1p+51 - 1.0, 1.0), sum);
  EXPECT_TRUE(in_range);
  EXPECT_EQ(sum, 1000 * ((std::int64_t{1} << 51) - 1));
}

TEST(FixedPoint, TheSumDoesNotDependOnTheOrder) {
  Draw draw(5);
  std::vector<double> values(500);
  for (double& v : values) v = std::ldexp(draw(-1.0, 1.0), static_cast<int>(draw(0.0, 40.0)));
  std::int64_t forwards = 0;
  std::int64_t backwards = 0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    add_fixed_point(to_fixed_point(values[k], 1024.0), forwards);
    add_fixed_point(to_fixed_point(values[values.size() - 1 - k], 1024.0), backwards);
  }
  EXPECT_EQ(forwards, backwards);
  EXPECT_NE(forwards, 0);
}

}  // namespace
}  // namespace repose::test
