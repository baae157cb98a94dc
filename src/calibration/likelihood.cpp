#include "calibration/likelihood.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "calibration/matern_kernel.h"
#include "calibration/minimise.h"

namespace repose {
namespace {

// The prior: normal in the logarithms. A few points say little about a length scale, and a likelihood with its maximum
// at no or at infinite length would make the surface a comb or a plane without doubt. A response that varies over the
// box as a whole, as those of grains do, has a length near the box.
constexpr double usual_log_length = 0.0;
constexpr double log_length_scatter = 1.0;

constexpr double least_noise = 1e-9;      // keeps the covariance of noise-free values positive definite
constexpr double least_variance = 1e-20;  // of standardised values that are all equal

/// ln of the prior times -2, and its gradient added.
double penalty(const Vector& log_parameters, Vector& gradient) {
  const Index d = log_parameters.size() - 1;
  double sum = 0.0;
  for (Index j = 0; j <= d; ++j) {
    const double scatter = j < d ? log_length_scatter : log_noise_scatter;
    const double off = (log_parameters[j] - (j < d ? usual_log_length : usual_log_noise)) / scatter;
    sum += off * off;
    gradient[j] += 2.0 * off / scatter;
  }
  return sum;
}

}  // namespace

Matrix mean_terms(const Matrix& points, bool linear) {
  Matrix terms = Matrix::Ones(points.rows(), linear ? 1 + points.cols() : 1);
  if (linear) terms.rightCols(points.cols()) = points.array() - 0.5;
  return terms;
}

bool bears_plane(const Replicates& data) {
  constexpr double least_pivot = 1e-6;  // of the greatest: below it the points lie in less than the box
  if (data.size() < 3 * (data.points.cols() + 1)) return false;
  Eigen::ColPivHouseholderQR<Matrix> qr(mean_terms(data.points, true));
  qr.setThreshold(least_pivot);
  return qr.rank() == data.points.cols() + 1;
}

Hyperparameters hyperparameters_at(const Vector& log_parameters) {
  const Index d = log_parameters.size() - 1;
  return {.lengths = log_parameters.head(d).array().exp(), .noise_ratio = least_noise + std::exp(log_parameters[d])};
}

Factors factorise(const Replicates& data, const Hyperparameters& hyperparameters, bool linear) {
  Factors f;
  Matrix covariance = MaternKernel{hyperparameters.lengths}.between(data.points, data.points);
  covariance.diagonal() += hyperparameters.noise_ratio * data.count.cwiseInverse();  // (C.2)
  f.covariance.compute(covariance);
  f.terms = mean_terms(data.points, linear);
  f.weighted_terms = f.covariance.solve(f.terms);
  const Matrix information = f.terms.transpose() * f.weighted_terms;
  f.coefficient_covariance = information.llt().solve(Matrix::Identity(information.rows(), information.cols()));
  f.coefficients = f.coefficient_covariance * (f.weighted_terms.transpose() * data.mean);  // (C.3)
  const Vector residual = data.mean - f.terms * f.coefficients;
  f.weights = f.covariance.solve(residual);
  f.freedom = static_cast<double>(data.size() - f.terms.cols()) + data.freedom_within;
  const double squares = residual.dot(f.weights) + data.squares_within / hyperparameters.noise_ratio;
  f.signal_variance = std::max(squares / f.freedom, least_variance);  // (C.4)
  return f;
}

double penalised_deviance(const Replicates& data, const Vector& log_parameters, bool linear, Vector& gradient) {
  const Index d = log_parameters.size() - 1;
  gradient = Vector::Zero(d + 1);
  const Hyperparameters hyperparameters = hyperparameters_at(log_parameters);
  const Factors f = factorise(data, hyperparameters, linear);
  if (f.covariance.info() != Eigen::Success) return std::numeric_limits<double>::infinity();
  const double g = hyperparameters.noise_ratio;

  // (C.5)
  const Matrix lower = f.covariance.matrixL();
  const double determinants =
      2.0 * lower.diagonal().array().log().sum() - std::log(f.coefficient_covariance.determinant());
  const double deviance = f.freedom * std::log(f.signal_variance) + determinants + data.freedom_within * std::log(g);

  // (C.6): the derivative by a change K' of the covariance is the sum of all elements of slope times K'.
  const Index n = data.size();
  const Matrix slope = f.covariance.solve(Matrix::Identity(n, n)) -
                       f.weighted_terms * f.coefficient_covariance * f.weighted_terms.transpose() -
                       f.weights * f.weights.transpose() / f.signal_variance;
  const Matrix kernel_slope =
      slope.cwiseProduct(MaternKernel{hyperparameters.lengths}.slopes(data.points, data.points));
  for (Index j = 0; j < d; ++j) {
    const Vector x = data.points.col(j) / hyperparameters.lengths[j];
    const Matrix apart = x.rowwise().replicate(n) - x.transpose().colwise().replicate(n);
    gradient[j] = kernel_slope.cwiseProduct(apart.cwiseAbs2()).sum();
  }
  const double within = (data.freedom_within - data.squares_within / (f.signal_variance * g)) / g;
  gradient[d] = (slope.diagonal().cwiseQuotient(data.count).sum() + within) * (g - least_noise);
  return deviance + penalty(log_parameters, gradient);
}

Hyperparameters most_likely(const Replicates& data, bool linear) {
  const Index d = data.points.cols();
  struct Start {
    double length;
    double noise_ratio;
  };
  constexpr Start starts[] = {{0.3, 1e-2}, {1.0, 1e-4}, {1.0, 1.0}, {3.0, 1e-2}};
  const Objective deviance = [&](const Vector& x, Vector& gradient) {
    return penalised_deviance(data, x, linear, gradient);
  };
  Minimum best;
  best.value = std::numeric_limits<double>::infinity();
  for (const Start& start : starts) {
    Vector x = Vector::Constant(d + 1, std::log(start.length));
    x[d] = std::log(start.noise_ratio);
    const Minimum found = minimise(deviance, x);
    if (found.value < best.value || best.x.size() == 0) best = found;
  }
  return hyperparameters_at(best.x);
}

}  // namespace repose
