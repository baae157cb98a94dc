// Local minima and connected parts of a region, of residuals that are known functions.
#include <cmath>

#include <gtest/gtest.h>

#include "calibration/confidence_part.h"
#include "calibration_samples.h"

namespace repose {
namespace {

ConfidencePart part_about(const Residuals& residuals, const Vector& seed, double limit, Index side = 81) {
  return confidence_part(residuals, evaluate(residuals, unit_lattice(seed.size(), side)), seed, limit);
}

// (x - a)^T A^-1 (x - a) <= limit reaches from a_j - sqrt(limit A_jj) to a_j + sqrt(limit A_jj).
TEST(ConfidencePart, OfAnEllipseIsItsExtent) {
  for (const double size : {0.1, 0.003, 1e-5}) {
    for (const double correlation : {0.0, 0.9, -0.9995}) {  // the last one is 1 : 63
      Matrix covariance(2, 2);
      covariance << size * size, correlation * size * 0.5 * size, correlation * size * 0.5 * size, 0.25 * size * size;
      const Eigen::LLT<Matrix> factor(covariance);
      const Vector centre = vector_of({0.41, 0.57});
      const Residuals ellipse = [&](const Vector& x) -> Vector { return factor.matrixL().solve(x - centre); };
      const ConfidencePart part = part_about(ellipse, centre, 5.991);
      for (Index j = 0; j < 2; ++j) {
        const double half = std::sqrt(5.991 * covariance(j, j));
        EXPECT_NEAR((part.upper[j] - centre[j]) / half, 1.0, 2e-3) << size << " " << correlation;
        EXPECT_NEAR((centre[j] - part.lower[j]) / half, 1.0, 2e-3) << size << " " << correlation;
        EXPECT_FALSE(part.open_below[static_cast<std::size_t>(j)]);
        EXPECT_FALSE(part.open_above[static_cast<std::size_t>(j)]);
      }
    }
  }
}

TEST(ConfidencePart, OfAnEllipsoidAndOfALine) {
  const Vector centre = vector_of({0.3, 0.5, 0.6});
  const Residuals ellipsoid = [&](const Vector& x) -> Vector {
    return (x - centre).cwiseQuotient(vector_of({0.05, 0.1, 0.02}));
  };
  const ConfidencePart part = part_about(ellipsoid, centre, 4.0, 21);
  EXPECT_NEAR(part.lower[0], 0.2, 1e-3);
  EXPECT_NEAR(part.upper[1], 0.7, 2e-3);
  EXPECT_NEAR(part.upper[2], 0.64, 4e-4);
  const ConfidencePart line =
      part_about([](const Vector& x) -> Vector { return (x.array() - 0.4) / 0.1; }, vector_of({0.4}), 1.0, 401);
  EXPECT_NEAR(line.lower[0], 0.3, 1e-4);
  EXPECT_NEAR(line.upper[0], 0.5, 1e-4);
}

// A ring section: the ends in x are on the arms, not where the curve is followed at one y only.
TEST(ConfidencePart, OfACurvedBandReachesAroundTheBend) {
  const Residuals band = [](const Vector& x) -> Vector {
    const double u = x[0] - 0.5;
    return vector_of({(std::hypot(u, x[1] - 0.2) - 0.3) / 0.01, std::min(0.0, x[1] - 0.25) / 0.001});
  };
  const ConfidencePart part = part_about(band, vector_of({0.5, 0.5}), 1.0);
  EXPECT_NEAR(part.lower[0], 0.5 - std::sqrt(0.31 * 0.31 - 0.05 * 0.05), 1e-3);
  EXPECT_NEAR(part.upper[0], 0.5 + std::sqrt(0.31 * 0.31 - 0.05 * 0.05), 1e-3);
  EXPECT_NEAR(part.upper[1], 0.51, 1e-3);
  EXPECT_NEAR(part.lower[1], 0.249, 1e-3);
}

TEST(ConfidencePart, IsOpenWhereItMeetsTheEdge) {
  const Residuals band = [](const Vector& x) -> Vector { return vector_of({(x[0] - 0.05) / 0.1, 0.0}); };
  const ConfidencePart part = part_about(band, vector_of({0.05, 0.5}), 1.0);
  EXPECT_TRUE(part.open_below[0]);
  EXPECT_FALSE(part.open_above[0]);
  EXPECT_TRUE(part.open_below[1]);
  EXPECT_TRUE(part.open_above[1]);
  EXPECT_EQ(part.lower[0], 0.0);
  EXPECT_NEAR(part.upper[0], 0.15, 1e-4);
  EXPECT_EQ(part.upper[1], 1.0);
}

TEST(ConfidencePart, LeavesOutWhatIsNotConnected) {
  const Residuals two = [](const Vector& x) -> Vector {
    return vector_of({(x[0] - 0.3) * (x[0] - 0.7) / 0.01, (x[1] - 0.5) / 0.05});
  };
  const ConfidencePart part = part_about(two, vector_of({0.3, 0.5}), 1.0);
  EXPECT_NEAR(part.upper[0], 0.5 - std::sqrt(0.03), 1e-4);
  EXPECT_TRUE(part.contains(vector_of({0.3, 0.5})));
  EXPECT_FALSE(part.contains(vector_of({0.7, 0.5})));
}

// Two bands, of which the one reaches over the whole box.
TEST(ConfidencePart, DoesNotLeadOverAGap) {
  const Residuals two = [](const Vector& x) -> Vector {
    const double first = x[1] - 0.3 - 0.3 * x[0];
    return vector_of({first * std::hypot(x[0] - 0.6, x[1] - 0.35) / 0.002, 0.0});
  };
  const Vector other = vector_of({0.6, 0.35});
  const ConfidencePart band = part_about(two, vector_of({0.2, 0.36}), 1.0, 81);
  EXPECT_FALSE(band.contains(other));
  EXPECT_FALSE(leads_to(two, band, other, 1.0));
  EXPECT_FALSE(have_same_extent(band, part_about(two, other, 1.0, 81)));
}

// x^2 + y^2 = 1/2 and x = y cross at (1/2, 1/2); x y = 0.1 and x + y = 1 at two points.
TEST(LocalMinima, AreTheCrossingsOfKnownCurves) {
  const Residuals one = [](const Vector& x) -> Vector { return vector_of({x.squaredNorm() - 0.5, x[0] - x[1]}); };
  auto minima = local_minima(one, evaluate(one, unit_lattice(2, 61)));
  ASSERT_FALSE(minima.empty());
  EXPECT_NEAR(minima[0].point[0], 0.5, 1e-9);
  EXPECT_NEAR(minima[0].point[1], 0.5, 1e-9);
  EXPECT_LT(minima[0].squares, 1e-16);

  const Residuals two = [](const Vector& x) -> Vector { return vector_of({x[0] * x[1] - 0.1, x.sum() - 1.0}); };
  minima = local_minima(two, evaluate(two, unit_lattice(2, 61)));
  ASSERT_GE(minima.size(), 2U);
  const double root = std::sqrt(0.25 - 0.1);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_LT(minima[k].squares, 1e-16);
    EXPECT_NEAR(std::fabs(minima[k].point[0] - 0.5), root, 1e-8);
  }
  EXPECT_GT(std::fabs(minima[0].point[0] - minima[1].point[0]), root);
}

TEST(Descend, AsksForNothingBeyondTheBox) {
  const Residuals within = [](const Vector& x) -> Vector {
    EXPECT_GE(x.minCoeff(), 0.0);
    EXPECT_LE(x.maxCoeff(), 1.0);
    return vector_of({std::sqrt(x[0]) - 0.5, 3.0 * (x[1] - 0.3)});
  };
  const LeastSquares low = descend(within, vector_of({0.0, 1.0}));
  EXPECT_NEAR(low.point[0], 0.25, 1e-6);
  EXPECT_NEAR(low.point[1], 0.3, 1e-6);
}

TEST(Descend, StaysInTheBoxAndHoldsWhatIsHeld) {
  const Residuals beyond = [](const Vector& x) -> Vector { return vector_of({x[0] - 1.4, 3.0 * (x[1] - 0.3)}); };
  LeastSquares low = descend(beyond, vector_of({0.2, 0.9}));
  EXPECT_EQ(low.point[0], 1.0);
  EXPECT_NEAR(low.point[1], 0.3, 1e-8);
  EXPECT_NEAR(low.squares, 0.16, 1e-9);
  low = descend(beyond, vector_of({0.2, 0.9}), 0);
  EXPECT_EQ(low.point[0], 0.2);
  EXPECT_NEAR(low.point[1], 0.3, 1e-8);
}

}  // namespace
}  // namespace repose
