// Restricted likelihood: against its own definition, and its gradient against differences.
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "calibration/likelihood.h"
#include "calibration/matern_kernel.h"
#include "calibration/minimise.h"
#include "calibration/shared_noise.h"
#include "calibration_samples.h"

namespace repose {
namespace {

Replicates noisy_runs(Index times) {
  const Matrix points = unit_grid(4, times);
  std::vector<double> values = values_at(points, [](double x, double y) { return std::exp(x) - 2.0 * x * y; });
  for (std::size_t i = 0; i < values.size(); ++i) values[i] += 0.2 * std::sin(91.0 * static_cast<double>(i));
  return replicates_of(points, values);
}

TEST(Likelihood, GradientIsThatOfDifferences) {
  for (const bool linear : {false, true}) {
    for (const Index times : {1, 3}) {
      const Replicates data = noisy_runs(times);
      const Vector at = vector_of({-0.5, 0.4, -2.0});
      Vector gradient;
      Vector unused;
      penalised_deviance(data, at, linear, gradient);
      for (Index j = 0; j < at.size(); ++j) {
        Vector step = Vector::Zero(at.size());
        step[j] = 1e-5;
        const double slope = (penalised_deviance(data, at + step, linear, unused) -
                              penalised_deviance(data, at - step, linear, unused)) /
                             2e-5;
        EXPECT_NEAR(gradient[j], slope, 1e-6);
      }
    }
  }
}

// The definition: the density of the differences A^T y of all runs that no mean can change, at the signal variance that
// is the most likely. Between two hyperparameters only constants of the data may be lost on the way to (C.5).
TEST(Likelihood, IsThatOfAllRunsWithoutTheirMean) {
  const Index times = 2;
  const Matrix points = unit_grid(3, times);
  std::vector<double> values = values_at(points, [](double x, double y) { return x + y * y; });
  for (std::size_t i = 0; i < values.size(); ++i) values[i] += 0.2 * std::sin(91.0 * static_cast<double>(i));
  const Replicates data = replicates_of(points, values);
  const Vector y = Eigen::Map<const Vector>(values.data(), points.rows());
  const Matrix terms = mean_terms(points, true);
  const Matrix q = terms.householderQr().householderQ() * Matrix::Identity(points.rows(), points.rows());
  const Matrix contrasts = q.rightCols(points.rows() - terms.cols());
  const auto deviance_by_definition = [&](const Hyperparameters& h) {
    Matrix covariance = MaternKernel{h.lengths}.between(points, points);
    covariance.diagonal().array() += h.noise_ratio;
    const Matrix seen = contrasts.transpose() * covariance * contrasts;
    const Vector z = contrasts.transpose() * y;
    const auto m = static_cast<double>(seen.rows());
    return m * std::log(z.dot(seen.ldlt().solve(z)) / m) + std::log(seen.determinant());
  };
  // The prior is normal in the logarithms, of lengths about 1 with scatter 1, of the noise ratio about -4.6 with 4.
  const auto prior = [](const Vector& x) { return x[0] * x[0] + x[1] * x[1] + (x[2] + 4.6) * (x[2] + 4.6) / 16.0; };
  const auto lost = [&](const Vector& x) {
    Vector gradient;
    return penalised_deviance(data, x, true, gradient) - prior(x) - deviance_by_definition(hyperparameters_at(x));
  };
  EXPECT_NEAR(lost(vector_of({-0.5, 0.4, -2.0})), lost(vector_of({0.7, -1.0, -0.3})), 1e-8);
}

TEST(Likelihood, NoiseIsThatOfTheSeeds) {
  const Replicates data = noisy_runs(40);
  const Hyperparameters h = most_likely(data, true);
  const Factors f = factorise(data, h, true);
  const double within = data.squares_within / data.freedom_within;
  EXPECT_NEAR(f.signal_variance * h.noise_ratio / within, 1.0, 0.02);
}

// Rosenbrock's valley, whose minimum is 0 at (1, 1).
TEST(Minimise, FindsTheEndOfACurvedValley) {
  const Minimum found = minimise(
      [](const Vector& x, Vector& gradient) {
        const double a = 1.0 - x[0];
        const double b = x[1] - x[0] * x[0];
        gradient = vector_of({-2.0 * a - 400.0 * x[0] * b, 200.0 * b});
        return a * a + 100.0 * b * b;
      },
      vector_of({-1.2, 1.0}));
  EXPECT_NEAR(found.x[0], 1.0, 1e-3);
  EXPECT_NEAR(found.x[1], 1.0, 1e-3);
}

// Where observables lack values their correlation is that of the runs that have both. rest_b = 0.9 rest_a + what is
// independent of it, exactly, at each point of three runs; a fourth and fifth run have the one alone.
TEST(SharedNoise, IsThatOfTheRunsThatHaveBoth) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  Matrix points(50, 1);
  std::vector<double> a, b;
  const double across = std::sqrt(1.0 - 0.9 * 0.9) / std::sqrt(3.0);
  for (Index run = 0; run < 50; ++run) {
    const Index k = run % 5;
    points(run, 0) = 0.1 * static_cast<double>(run / 5);
    const double along[] = {1.0, -1.0, 0.0, 7.0, -4.0};
    const double other[] = {1.0, 1.0, -2.0, 0.0, 0.0};
    a.push_back(3.0 + along[k]);
    b.push_back(k < 3 ? 5.0 + 0.9 * along[k] + across * other[k] : none);
  }
  const SharedNoise shared = shared_noise(replicates_of(points, a), replicates_of(points, b));
  EXPECT_NEAR(shared.correlation, 0.9, 1e-12);
  // Ten points of which one run each has both say nothing.
  for (std::size_t run = 0; run < 50; ++run) {
    if (run % 5 > 0) b[run] = none;
  }
  EXPECT_EQ(shared_noise(replicates_of(points, a), replicates_of(points, b)).correlation, 0.0);
}

}  // namespace
}  // namespace repose
