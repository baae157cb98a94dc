#include <cmath>

#include <gtest/gtest.h>

#include "deck_error.h"
#include "fields/grid.h"
#include "fields/kernel.h"

namespace repose::fields {
namespace {

TEST(FieldsKernel, IsTheIntegralOfTheCubicSpline) {
  const auto spline = [](double u) {
    const double a = std::fabs(u);
    return a >= 2.0 ? 0.0 : a >= 1.0 ? std::pow(2.0 - a, 3) / 6.0 : 2.0 / 3.0 - a * a + 0.5 * a * a * a;
  };
  constexpr double h = 1e-3;
  for (double u = -2.3; u < 2.4; u += 0.05) {
    const double slope = (spline_below(u + h) - spline_below(u - h)) / (2.0 * h);
    EXPECT_NEAR(slope, spline(u), 0.5 * h * h) << u;  // h^2/6 of the second derivative, 2 at most
    EXPECT_NEAR(spline_below(u) + spline_below(-u), 1.0, 1e-15);
  }
  EXPECT_EQ(spline_below(-2.0), 0.0);
  EXPECT_EQ(spline_below(2.0), 1.0);
}

TEST(FieldsKernel, HasAStandardDeviationOfItsHalfWidthOverTheRootOf12) {
  constexpr double width = 0.7;
  constexpr double cell = 1e-3;
  double variance = 0.0;
  for (double x = -width; x < width; x += cell) {
    const double middle = x + 0.5 * cell;
    variance += middle * middle * (kernel_below(x + cell, width) - kernel_below(x, width));
  }
  EXPECT_NEAR(variance, width * width / 12.0, cell * cell);  // of the cells: cell^2 / 12
}

TEST(FieldsGrid, HoldsAllKernelsAtMultiplesOfTheSpacing) {
  const Grid grid = grid_around({0.11, -0.3, 0.0}, {0.49, 0.2, 0.0}, {}, {.width = 0.2, .spacing = 0.1}, "a.hdf");
  for (std::size_t d = 0; d < 3; ++d) {
    EXPECT_NEAR(grid.origin[d], 0.1 * std::rint(10.0 * grid.origin[d]), 1e-15);
    EXPECT_FALSE(grid.periodic[d]);
  }
  EXPECT_LE(grid.origin[0], 0.11 - 0.2);
  EXPECT_GE(grid.origin[0] + 0.1 * static_cast<double>(grid.cells[0]), 0.49 + 0.2);
  EXPECT_LE(grid.cells[0], 11U);
}

TEST(FieldsGrid, IsTheDomainWhereThatIsPeriodic) {
  DomainDeck domain;
  domain.min = {-0.5, -1.0, 0.0};
  domain.max = {0.5, 1.0, 1.0};
  domain.periodic = {Axis::y};
  const Grid grid = grid_around({0.0, 0.0, 0.0}, {0.1, 0.1, 0.1}, domain, {.width = 0.2, .spacing = 0.3}, "a.hdf");
  EXPECT_EQ(grid.origin[1], -1.0);
  EXPECT_EQ(grid.cells[1], 7U);
  EXPECT_DOUBLE_EQ(grid.spacing[1], 2.0 / 7.0);
  EXPECT_TRUE(grid.periodic[1]);
}

TEST(FieldsGrid, RefusesMoreCellsThanMemoryHolds) {
  EXPECT_EQ(test::deck_error([] {
              grid_around({0, 0, 0}, {1, 1, 1}, {}, {.width = 0.01, .spacing = 0.001}, "a.hdf");
            }),
            "a.hdf: 1.02e+03 x 1.02e+03 x 1.02e+03 cells of 0.001 m are more than 2e+07; give a larger --spacing");
}

}  // namespace
}  // namespace repose::fields
