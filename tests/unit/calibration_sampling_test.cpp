// Samples of densities that are known in closed form. Tolerances: with some thousand samples that are not quite
// independent, errors of means are 0.03 deviations or less, those of deviations 3 %; four times that is allowed.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "base/error.h"
#include "calibration/sample_density.h"
#include "calibration_samples.h"

namespace repose {
namespace {

constexpr double nothing = -std::numeric_limits<double>::infinity();

BoxDensity over_box(std::function<double(const Vector&)> log_likelihood) {
  return {.draw = [](const Vector& shares) { return shares; },
          .log_prior = [](const Vector&) { return 0.0; },
          .log_likelihood = std::move(log_likelihood)};
}

double deviation_of(const Vector& values) { return std::sqrt((values.array() - values.mean()).square().mean()); }

double share_of(const Eigen::Array<bool, Eigen::Dynamic, 1>& which) {
  return static_cast<double>(which.count()) / static_cast<double>(which.size());
}

// Six parameters, of which each goes with the next.
TEST(SampleDensity, OfAGaussian) {
  constexpr Index d = 6;
  Vector deviation(d);
  deviation << 0.1, 0.05, 0.02, 0.01, 0.03, 0.06;
  Vector middle(d);
  middle << 0.5, 0.4, 0.6, 0.3, 0.5, 0.55;
  Matrix covariance(d, d);
  for (Index i = 0; i < d; ++i) {
    for (Index j = 0; j < d; ++j) {
      covariance(i, j) = deviation[i] * deviation[j] * std::pow(-0.8, std::abs(static_cast<double>(i - j)));
    }
  }
  const Eigen::LLT<Matrix> factor(covariance);
  const Samples s = sample_density(
      over_box([&](const Vector& x) { return -0.5 * factor.matrixL().solve(x - middle).squaredNorm(); }), d, {});
  EXPECT_GT(s.points.rows(), 3000);
  EXPECT_GT(s.acceptance, 0.15);
  for (Index j = 0; j < d; ++j) {
    const Vector x = s.points.col(j);
    EXPECT_NEAR(x.mean(), middle[j], 0.12 * deviation[j]) << j;
    EXPECT_NEAR(deviation_of(x) / deviation[j], 1.0, 0.12) << j;
    EXPECT_NEAR(share_of(x.array() < middle[j] - 1.96 * deviation[j]), 0.025, 0.012) << j;
    if (j == 0) continue;
    const Vector before = s.points.col(j - 1);
    const double product = (x.array() - x.mean()).matrix().dot((before.array() - before.mean()).matrix());
    const double correlation = product / (static_cast<double>(x.size()) * deviation_of(x) * deviation_of(before));
    EXPECT_NEAR(correlation, -0.8, 0.06) << j;
  }
  // -2 ln density is chi-squared with 6 degrees of freedom, of which 95 % lie below 12.59.
  EXPECT_NEAR(share_of(s.log_density.array() > -0.5 * 12.592), 0.95, 0.02);
}

// v = u^2 - 1 + 0.3 w with normal u and w: no correlation, a variance of 2 + 0.09, and all that is curved.
TEST(SampleDensity, OfABanana) {
  const auto u_of = [](const auto& x) { return (x - 0.5) / 0.1; };
  const auto v_of = [](const auto& x) { return (x - 0.3) / 0.035; };
  const Samples s = sample_density(over_box([&](const Vector& x) {
                                     const double u = u_of(x[0]);
                                     const double w = (v_of(x[1]) - u * u + 1.0) / 0.3;
                                     return -0.5 * (u * u + w * w);
                                   }),
                                   2, {});
  const Eigen::ArrayXd u = u_of(s.points.col(0).array());
  const Eigen::ArrayXd v = v_of(s.points.col(1).array());
  EXPECT_NEAR(u.mean(), 0.0, 0.12);
  EXPECT_NEAR(deviation_of(u), 1.0, 0.1);
  EXPECT_NEAR(v.mean(), 0.0, 0.18);
  EXPECT_NEAR(deviation_of(v), std::sqrt(2.09), 0.2);
  EXPECT_NEAR((u * v).mean(), 0.0, 0.3);
  EXPECT_NEAR(share_of(u.abs() < 1.0), 0.6827, 0.05);
  EXPECT_NEAR(share_of(v > 2.0), 0.0837, 0.03);  // P(u^2 > 3) and what w adds to either side
  EXPECT_NEAR(deviation_of(v - u.square()), 0.3, 0.03);
}

// All that is left of the box is the corner where the sum is below 0.6: P(x > t) = (1 - t / 0.6)^3, mean 0.15.
TEST(SampleDensity, OfATruncatedUniform) {
  const Samples s = sample_density(over_box([](const Vector& x) { return x.sum() < 0.6 ? 0.0 : nothing; }), 3, {});
  EXPECT_LT(s.points.rowwise().sum().maxCoeff(), 0.6);
  EXPECT_GE(s.points.minCoeff(), 0.0);
  for (Index j = 0; j < 3; ++j) {
    const Eigen::ArrayXd x = s.points.col(j).array();
    EXPECT_NEAR(x.mean(), 0.15, 0.015) << j;
    EXPECT_NEAR(share_of(x > 0.3), 0.125, 0.03) << j;
    EXPECT_NEAR(share_of(x < 0.03), 1.0 - std::pow(0.95, 3.0), 0.03) << j;
  }
}

// A wide one with a quarter of all and a narrow one far from it.
TEST(SampleDensity, KeepsTheSharesOfTwoMaxima) {
  const auto normal = [](const Vector& x, double middle, double deviation) {
    return std::exp(-0.5 * (x.array() - middle).square().sum() / (deviation * deviation)) / std::pow(deviation, 3.0);
  };
  const Samples s = sample_density(
      over_box([&](const Vector& x) { return std::log(0.25 * normal(x, 0.25, 0.05) + 0.75 * normal(x, 0.8, 0.02)); }),
      3, {});
  const Eigen::ArrayXd x = s.points.col(0).array();
  EXPECT_NEAR(share_of(x < 0.5), 0.25, 0.08);
  EXPECT_EQ(share_of(x > 0.5 && x < 0.65), 0.0);
}

TEST(SampleDensity, IsTheSameAgainAndAnotherWithAnotherSeed) {
  const BoxDensity density = over_box([](const Vector& x) { return -50.0 * (x.array() - 0.4).square().sum(); });
  const SamplePlan plan = {.walkers = 40, .moves = 2, .settling = 2, .kept = 2, .apart = 2};
  const Samples first = sample_density(density, 4, plan);
  EXPECT_EQ(first.points, sample_density(density, 4, plan).points);
  EXPECT_EQ(first.points.rows(), 80);
  SamplePlan other = plan;
  other.seed = 2;
  EXPECT_NE(first.points, sample_density(density, 4, other).points);
}

TEST(SampleDensity, OfNothingIsRefused) {
  EXPECT_THROW(sample_density(over_box([](const Vector&) { return nothing; }), 2, {}), DeckError);
}

}  // namespace
}  // namespace repose
