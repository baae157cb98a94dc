// Gaussian process: closed forms at few points, noise-free data, gradients, replicates.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "calibration/gaussian_process.h"
#include "calibration_samples.h"

namespace repose {
namespace {

double smooth(double x, double y) { return std::sin(3.0 * x) + x * y * y; }

// Two points and a constant mean, by hand: with correlation c of the points and k1, k2 with the place asked for,
// the mean is (y1 + y2) / 2 and the variance of a value s^2 = (y1 - y2)^2 / (2 (1 + g - c)).
TEST(GaussianProcess, OfTwoPointsByHand) {
  const double g = 0.1;
  const Replicates data = replicates_of(rows({{0.2}, {0.7}}), std::vector<double>{3.0, 4.0});
  const GaussianProcess process(data, {.lengths = vector_of({0.5}), .noise_ratio = g});
  const auto matern = [](double r) { return (1 + std::sqrt(5) * r + 5 * r * r / 3) * std::exp(-std::sqrt(5) * r); };
  const double c = matern(1.0);
  const double k1 = matern(0.2);
  const double k2 = matern(0.8);
  const double s2 = 1.0 / (2.0 * (1.0 + g - c));
  const SurfaceValue at = process.at(vector_of({0.3}));
  EXPECT_NEAR(process.signal_variance(), s2, 1e-13);
  EXPECT_NEAR(process.noise_variance(), g * s2, 1e-13);
  EXPECT_NEAR(at.mean, 3.5 + 0.5 * (k2 - k1) / (1.0 + g - c), 1e-13);
  // Along (1, 1) and (1, -1) the 2 by 2 matrix is diagonal: 1 + g + c and 1 + g - c.
  const double sum = k1 + k2;
  const double difference = k1 - k2;
  const double known = 0.5 * sum * sum / (1.0 + g + c) + 0.5 * difference * difference / (1.0 + g - c);
  const double left = 1.0 - sum / (1.0 + g + c);
  EXPECT_NEAR(at.deviation * at.deviation, s2 * (1.0 - known + 0.5 * left * left * (1.0 + g + c)), 1e-13);
}

TEST(GaussianProcess, FarFromThreePointsKnowsTheirMeanOnly) {
  const Replicates data = replicates_of(rows({{0.0}, {50.0}, {100.0}}), std::vector<double>{1.0, 2.0, 6.0});
  const GaussianProcess process(data, {.lengths = vector_of({1.0}), .noise_ratio = 1e-12});
  const SurfaceValue far = process.at(vector_of({75.0}));
  EXPECT_NEAR(process.signal_variance(), 7.0, 1e-10);  // uncorrelated: the sample variance
  EXPECT_NEAR(far.mean, 3.0, 1e-10);
  EXPECT_NEAR(far.deviation * far.deviation, 7.0 * (1.0 + 1.0 / 3.0), 1e-10);
}

TEST(GaussianProcess, GoesThroughValuesWithoutNoise) {
  const Matrix points = unit_grid(6);
  const std::vector<double> values = values_at(points, smooth);
  const GaussianProcess process(replicates_of(points, values));
  for (Index i = 0; i < points.rows(); ++i) {
    EXPECT_NEAR(process.at(points.row(i).transpose()).mean, values[static_cast<std::size_t>(i)], 2e-4);
  }
  // Between the points: the error of a smooth function on a grid of 0.2, and the process knows its size.
  const SurfaceValue between = process.at(vector_of({0.5, 0.5}));
  EXPECT_NEAR(between.mean, smooth(0.5, 0.5), 2e-3);
  EXPECT_LT(between.deviation, 0.02);
}

TEST(GaussianProcess, GradientIsThatOfItsMean) {
  const Matrix points = unit_grid(4);
  const GaussianProcess process(replicates_of(points, values_at(points, smooth)));
  const Vector at = vector_of({0.37, 0.81});
  const Vector gradient = process.gradient(at);
  for (Index j = 0; j < 2; ++j) {
    Vector step = Vector::Zero(2);
    step[j] = 1e-5;
    const double slope = (process.at(at + step).mean - process.at(at - step).mean) / 2e-5;
    EXPECT_NEAR(gradient[j], slope, 1e-6);
  }
}

TEST(GaussianProcess, WeightsAndCovarianceAreThoseOfItsValues) {
  const Matrix points = unit_grid(4, 2);
  std::vector<double> values = values_at(points, smooth);
  for (std::size_t i = 0; i < values.size(); i += 2) values[i] += 0.1;
  const GaussianProcess process(replicates_of(points, values));
  const Matrix places = rows({{0.3, 0.4}, {0.9, 0.1}});
  const Matrix covariance = process.covariance(places, places);
  for (Index i = 0; i < 2; ++i) {
    const SurfaceValue at = process.at(places.row(i).transpose());
    EXPECT_NEAR(process.weights(places.row(i).transpose()).dot(process.data().mean), at.mean, 1e-10);
    EXPECT_NEAR(covariance(i, i), at.deviation * at.deviation, 1e-12);
  }
  EXPECT_NEAR(covariance(0, 1), covariance(1, 0), 1e-12);
}

// The means of replicates and their scatter are all that 2 runs at a point say: the surface is that of all runs one by
// one, at points that hardly differ, with the same hyperparameters.
TEST(GaussianProcess, ReplicatesAreWorthTheirRuns) {
  const Matrix points = unit_grid(4, 2);
  Matrix apart = points;
  for (Index i = 0; i < apart.rows(); i += 2) apart(i, 0) += 1e-7;
  std::vector<double> values = values_at(points, smooth);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] += 0.1 * std::sin(37.0 * static_cast<double>(i));
  const Hyperparameters h = {.lengths = vector_of({0.6, 0.9}), .noise_ratio = 0.02};
  const GaussianProcess together(replicates_of(points, values), h);
  const GaussianProcess one_by_one(replicates_of(apart, values), h);
  ASSERT_EQ(together.data().size(), 16);
  ASSERT_EQ(one_by_one.data().size(), 32);
  const SurfaceValue a = together.at(vector_of({0.4, 0.6}));
  const SurfaceValue b = one_by_one.at(vector_of({0.4, 0.6}));
  EXPECT_NEAR(a.mean, b.mean, 1e-5);
  EXPECT_NEAR(a.deviation, b.deviation, 1e-5);
  EXPECT_NEAR(together.freedom(), one_by_one.freedom(), 1e-12);
}

TEST(GaussianProcess, OfValuesThatAreAllEqualIsFlat) {
  for (const Index times : {1, 3}) {
    const Matrix points = unit_grid(3, times);
    const GaussianProcess process(replicates_of(points, std::vector<double>(static_cast<std::size_t>(9 * times), 0.0)));
    const SurfaceValue at = process.at(vector_of({0.2, 0.7}));
    EXPECT_NEAR(at.mean, 0.0, 1e-9);
    EXPECT_NEAR(at.deviation, 0.0, 1e-9);
  }
}

// Ten points with the same first parameter, as where all runs beyond it have plugged, tell no slope along it.
TEST(GaussianProcess, OfPointsOnALineIsUncertainBesideIt) {
  Matrix points(10, 2);
  for (Index i = 0; i < 10; ++i) points.row(i) << 1.0, static_cast<double>(i) / 9.0;
  const Replicates data = replicates_of(points, values_at(points, smooth));
  EXPECT_FALSE(bears_plane(data));
  const GaussianProcess process(data, {.lengths = vector_of({0.5, 0.5}), .noise_ratio = 1e-6});
  const SurfaceValue far = process.at(vector_of({-20.0, 0.5}));
  EXPECT_NEAR(far.mean, process.at(vector_of({-40.0, 0.5})).mean, 1e-9);
  EXPECT_GT(far.deviation, std::sqrt(process.signal_variance()));
  EXPECT_TRUE(bears_plane(replicates_of(unit_grid(4), values_at(unit_grid(4), smooth))));
}

TEST(GaussianProcess, OfFourPointsInThreeParameters) {
  const Matrix points = rows({{0, 0, 0}, {1, 0, 1}, {0, 1, 1}, {1, 1, 0}});
  const GaussianProcess process(replicates_of(points, std::vector<double>{0.0, 1.0, 0.5, 1.5}));
  const SurfaceValue middle = process.at(vector_of({0.5, 0.5, 0.5}));
  EXPECT_NEAR(middle.mean, 0.75, 1e-6);
  EXPECT_GT(middle.deviation, 0.0);
}

}  // namespace
}  // namespace repose
