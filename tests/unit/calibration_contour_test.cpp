// Contour lines of known functions.
#include <cmath>

#include <gtest/gtest.h>

#include "base/math.h"
#include "calibration/contour_lines.h"

namespace repose {
namespace {

double length_of(const ContourLine& line) {
  double length = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i)
    length += std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y);
  return length;
}

TEST(ContourLines, OfAPlaneIsOneStraightLine) {
  const auto lines = contour_lines([](double x, double y) { return x + 2.0 * y; }, {0.0, 3.0}, {1.0, 2.0}, 4.0, 37);
  ASSERT_EQ(lines.size(), 1U);
  for (const PlanePoint& p : lines[0]) EXPECT_NEAR(p.x + 2.0 * p.y, 4.0, 1e-6);
  // From (0, 2) to (2, 1).
  EXPECT_NEAR(length_of(lines[0]), std::sqrt(5.0), 1e-5);
}

TEST(ContourLines, OfACircleIsOneClosedLine) {
  const auto lines =
      contour_lines([](double x, double y) { return x * x + y * y; }, {-1.0, 1.0}, {-1.0, 1.0}, 0.49, 100);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].front().x, lines[0].back().x);
  EXPECT_EQ(lines[0].front().y, lines[0].back().y);
  for (const PlanePoint& p : lines[0]) EXPECT_NEAR(std::hypot(p.x, p.y), 0.7, 1e-6);
  EXPECT_NEAR(length_of(lines[0]), 2.0 * pi * 0.7, 1e-3);  // chords of 0.02
}

TEST(ContourLines, OfASaddleAreTwo) {
  const auto saddle = [](double x, double y) { return x * y; };
  for (const double level : {-1e-4, 1e-4}) {
    const auto lines = contour_lines(saddle, {-1.0, 1.0}, {-1.0, 1.0}, level, 11);  // the middle is within a cell
    ASSERT_EQ(lines.size(), 2U);
    for (const ContourLine& line : lines) {
      for (const PlanePoint& p : line) EXPECT_EQ(p.x > 0.0, (p.y > 0.0) == (level > 0.0));
    }
  }
}

TEST(ContourLines, NoneWhereTheLevelIsNotReached) {
  EXPECT_TRUE(contour_lines([](double x, double) { return x; }, {0.0, 1.0}, {0.0, 1.0}, 2.0).empty());
}

TEST(ContourLines, EndWhereTheSurfaceEnds) {
  const auto half = [](double x, double y) { return x > 0.5 ? std::nan("") : y; };
  const auto lines = contour_lines(half, {0.0, 1.0}, {0.0, 1.0}, 0.45, 10);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NEAR(length_of(lines[0]), 0.5, 1e-9);
}

}  // namespace
}  // namespace repose
