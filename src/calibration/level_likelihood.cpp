#include "calibration/level_likelihood.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "calibration/likelihood.h"
#include "calibration/matern_kernel.h"
#include "calibration/minimise.h"

namespace repose {
namespace {

/// Normal in each parameter, as in (C.5): lengths near the box; a noise of 1 % of what the level adds, or a multiple.
/// Few seeds say little of how their scatter varies: it is the same everywhere unless they tell otherwise.
constexpr double noise_slope_scatter = 1.5;
/// With few points the likelihood may be greatest where a level adds nothing, and that would be taken for certain.
constexpr double usual_log_added = -2.3;
constexpr double log_added_scatter = 2.0;

constexpr int least_second_seeds = 4;  ///< with fewer, runs do not tell their scatter themselves

/// Without second seeds nothing tells how runs scatter but what their points are off a smooth surface, of which few
/// points say little. Then runs scatter as those of the level below do, within this of ln of the variance.
constexpr double log_noise_apart = 1.0;
constexpr double least_taken = 0.01;  ///< where the level below is of no use, it says little of the noise, too

constexpr int rounds_of_rho = 4;

/// Where the numbers stand in the vector that is varied.
struct Layout {
  Index d;
  Index added() const { return d; }
  Index noise() const { return d + 1; }
  Index size() const { return 2 * d + 2; }
};

LevelParameters parameters_at(const Vector& x, Index d) {
  const Layout at{d};
  return {.rho = 0.0,
          .lengths = x.head(d).array().exp(),
          .added_variance = std::exp(x[at.added()]),
          .noise = x.tail(d + 1)};
}

/// The prior of the noise: where each of its parameters is expected, and by how much it may be off.
struct NoisePrior {
  Vector mean, scatter;
  bool is_over_added = false;  ///< the first is relative to what the level adds
};

NoisePrior noise_prior(const Replicates& data, const BelowLevel& below, double taken) {
  const Index size = data.points.cols() + 1;
  if (below.noise.size() == 0 || has_own_scatter(data)) {
    NoisePrior prior = {Vector::Zero(size), Vector::Constant(size, noise_slope_scatter), true};
    prior.mean[0] = usual_log_noise;
    prior.scatter[0] = log_noise_scatter;
    return prior;
  }
  NoisePrior prior = {below.noise, Vector::Constant(size, log_noise_apart), false};
  prior.mean[0] += std::log(std::max(taken, least_taken));
  return prior;
}

double penalty(const Vector& x, Index d, bool is_lowest, const NoisePrior& noise, Vector& gradient) {
  const Layout at{d};
  double sum = 0.0;
  const auto add = [&](double off, double scatter, auto&& slopes) {
    sum += off * off / (scatter * scatter);
    slopes(2.0 * off / (scatter * scatter));
  };
  for (Index j = 0; j < d; ++j) {
    add(x[j], 1.0, [&](double slope) { gradient[j] += slope; });
  }
  for (Index j = 0; j <= d; ++j) {
    const bool over_added = noise.is_over_added && j == 0;
    add(x[at.noise() + j] - (over_added ? x[at.added()] : 0.0) - noise.mean[j], noise.scatter[j], [&](double slope) {
      gradient[at.noise() + j] += slope;
      if (over_added) gradient[at.added()] -= slope;
    });
  }
  if (!is_lowest) {
    add(x[at.added()] - usual_log_added, log_added_scatter, [&](double slope) { gradient[at.added()] += slope; });
  }
  return sum;
}

/// The terms of the mean: the level below, when there is one, then a constant or a plane.
Matrix terms_of(const Replicates& data, const BelowLevel& below) {
  const bool is_lowest = below.mean.size() == 0;
  const Matrix own = mean_terms(data.points, has_plane(data, is_lowest));
  if (is_lowest) return own;
  Matrix terms(own.rows(), own.cols() + 1);
  terms << below.mean, own;
  return terms;
}

struct LevelFactors {
  Eigen::LLT<Matrix> covariance;
  Matrix weighted_terms;
  Matrix coefficient_covariance;
  Vector coefficients;
  Vector weights;
  Matrix kernel;  ///< of what the level adds, with its variance
  Vector noise;   ///< variance of one run, at each point
};

LevelFactors factorise_level(const Replicates& data, const BelowLevel& below, double taken, const LevelParameters& h) {
  LevelFactors f;
  f.kernel = h.added_variance * MaternKernel{h.lengths}.between(data.points, data.points);
  f.noise.resize(data.size());
  for (Index i = 0; i < data.size(); ++i) f.noise[i] = h.noise_variance(data.points.row(i).transpose());
  Matrix covariance = f.kernel;
  if (below.mean.size() > 0) covariance += taken * below.covariance;
  covariance.diagonal() += f.noise.cwiseQuotient(data.count);
  f.covariance.compute(covariance);
  const Matrix terms = terms_of(data, below);
  f.weighted_terms = f.covariance.solve(terms);
  Matrix information = terms.transpose() * f.weighted_terms;
  if (below.mean.size() > 0) information(0, 0) += 1.0 / (rho_scatter * rho_scatter);
  f.coefficient_covariance = information.llt().solve(Matrix::Identity(information.rows(), information.cols()));
  f.coefficients = f.coefficient_covariance * (f.weighted_terms.transpose() * data.mean);
  f.weights = f.covariance.solve(data.mean - terms * f.coefficients);
  return f;
}

/// Squares of the runs about the mean of their point, summed at each point.
Vector squares_at_points(const Replicates& data) {
  Vector squares = Vector::Zero(data.size());
  for (std::size_t run = 0; run < data.point_of_run.size(); ++run) {
    if (data.point_of_run[run] >= 0) squares[data.point_of_run[run]] += data.rest_of_run[run] * data.rest_of_run[run];
  }
  return squares;
}

}  // namespace

bool has_plane(const Replicates& data, bool is_lowest) { return is_lowest && bears_plane(data); }

bool has_own_scatter(const Replicates& data) { return data.second_seeds() >= least_second_seeds; }

double level_deviance(const Replicates& data, const BelowLevel& below, double taken, const Vector& x,
                      Vector& gradient) {
  const Index d = data.points.cols();
  const Index n = data.size();
  const Layout at{d};
  gradient = Vector::Zero(at.size());
  const LevelParameters h = parameters_at(x, d);
  const LevelFactors f = factorise_level(data, below, taken, h);
  if (f.covariance.info() != Eigen::Success) return std::numeric_limits<double>::infinity();
  const Vector squares = squares_at_points(data);
  const Vector repeats = data.count.array() - 1.0;

  const Matrix lower = f.covariance.matrixL();
  double deviance = 2.0 * lower.diagonal().array().log().sum() - std::log(f.coefficient_covariance.determinant()) +
                    data.mean.dot(f.weights) + (repeats.array() * f.noise.array().log()).sum() +
                    squares.cwiseQuotient(f.noise).sum();

  const Matrix slope = f.covariance.solve(Matrix::Identity(n, n)) -
                       f.weighted_terms * f.coefficient_covariance * f.weighted_terms.transpose() -
                       f.weights * f.weights.transpose();
  const Matrix kernel_slope =
      h.added_variance * slope.cwiseProduct(MaternKernel{h.lengths}.slopes(data.points, data.points));
  const Vector by_noise =
      (slope.diagonal().cwiseQuotient(data.count) + (repeats - squares.cwiseQuotient(f.noise)).cwiseQuotient(f.noise))
          .cwiseProduct(Vector(f.noise.array() - LevelParameters::least_noise));
  for (Index j = 0; j < d; ++j) {
    const Vector place = data.points.col(j) / h.lengths[j];
    const Matrix apart = place.rowwise().replicate(n) - place.transpose().colwise().replicate(n);
    gradient[j] = kernel_slope.cwiseProduct(apart.cwiseAbs2()).sum();
    gradient[at.noise() + 1 + j] = by_noise.dot(Vector(data.points.col(j).array() - 0.5));
  }
  gradient[at.added()] = slope.cwiseProduct(f.kernel).sum();
  gradient[at.noise()] = by_noise.sum();
  return deviance + penalty(x, d, below.mean.size() == 0, noise_prior(data, below, taken), gradient);
}

LevelParameters most_likely_level(const Replicates& data, const BelowLevel& below) {
  struct Start {
    double length, added, noise;
  };
  constexpr Start starts[] = {{0.3, 0.3, 1e-2}, {1.0, 1.0, 1e-4}, {1.0, 0.1, 0.3}, {3.0, 1.0, 1e-2}};
  const Index d = data.points.cols();
  const Layout at{d};
  const bool is_lowest = below.mean.size() == 0;
  double taken = is_lowest ? 0.0 : 1.0;
  Minimum best;
  for (int round = 0; round < (is_lowest ? 1 : rounds_of_rho); ++round) {
    const Objective deviance = [&](const Vector& x, Vector& gradient) {
      return level_deviance(data, below, taken, x, gradient);
    };
    if (round > 0) {
      best = minimise(deviance, best.x);
    } else {
      best.value = std::numeric_limits<double>::infinity();
      for (const Start& start : starts) {
        Vector x = Vector::Zero(at.size());
        x.head(d).setConstant(std::log(start.length));
        x[at.added()] = std::log(start.added);
        x[at.noise()] = std::log(start.noise);
        const Minimum found = minimise(deviance, x);
        if (found.value < best.value || best.x.size() == 0) best = found;
      }
    }
    if (is_lowest) break;
    const double rho = factorise_level(data, below, taken, parameters_at(best.x, d)).coefficients[0];
    taken = rho * rho;
  }
  LevelParameters h = parameters_at(best.x, d);
  if (!is_lowest) h.rho = factorise_level(data, below, taken, h).coefficients[0];
  return h;
}

}  // namespace repose
