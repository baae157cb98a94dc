#include "calibration/gaussian_process.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace repose {

GaussianProcess::GaussianProcess(Replicates data)
    : data_(std::move(data)),
      linear_(bears_plane(data_)),
      hyperparameters_(most_likely(data_, linear_)),
      kernel_{hyperparameters_.lengths},
      f_(factorise(data_, hyperparameters_, linear_)) {}

GaussianProcess::GaussianProcess(Replicates data, const Hyperparameters& hyperparameters)
    : data_(std::move(data)),
      linear_(bears_plane(data_)),
      hyperparameters_(hyperparameters),
      kernel_{hyperparameters_.lengths},
      f_(factorise(data_, hyperparameters_, linear_)) {}

GaussianProcess::Look GaussianProcess::look(const Vector& point) const {
  const Vector near = kernel_.between(data_.points, point.transpose());
  const Vector terms = mean_terms(point.transpose(), linear_).transpose();
  Vector excess = terms - f_.weighted_terms.transpose() * near;
  Vector half = f_.covariance.matrixL().solve(near);
  const double share = 1.0 - half.squaredNorm() + excess.dot(f_.coefficient_covariance * excess);  // (C.8)
  return {.value = {.mean = terms.dot(f_.coefficients) + near.dot(f_.weights),                     // (C.7)
                    .deviation = std::sqrt(f_.signal_variance * std::max(0.0, share))},
          .excess = std::move(excess),
          .half = std::move(half)};
}

SurfaceValue GaussianProcess::at(const Vector& point, Vector& weights) const {
  const Look found = look(point);
  weights = f_.covariance.matrixU().solve(found.half);
  weights += f_.weighted_terms * (f_.coefficient_covariance * found.excess);
  return found.value;
}

Vector GaussianProcess::gradient(const Vector& point) const {
  const Vector slopes = kernel_.slopes(data_.points, point.transpose());
  Vector gradient = Vector::Zero(point.size());
  if (linear_) gradient = f_.coefficients.tail(point.size());
  for (Index j = 0; j < point.size(); ++j) {
    const Vector apart = point[j] - data_.points.col(j).array();
    gradient[j] -=
        (f_.weights.array() * slopes.array() * apart.array()).sum() / (kernel_.lengths[j] * kernel_.lengths[j]);
  }
  return gradient;
}

Vector GaussianProcess::weights(const Vector& point) const {
  Vector weights;
  at(point, weights);
  return weights;
}

Matrix GaussianProcess::covariance(const Matrix& a, const Matrix& b) const {
  const Matrix near_a = kernel_.between(data_.points, a);
  const Matrix near_b = kernel_.between(data_.points, b);
  const Matrix excess_a = mean_terms(a, linear_).transpose() - f_.weighted_terms.transpose() * near_a;
  const Matrix excess_b = mean_terms(b, linear_).transpose() - f_.weighted_terms.transpose() * near_b;
  return f_.signal_variance * (kernel_.between(a, b) - near_a.transpose() * f_.covariance.solve(near_b) +
                               excess_a.transpose() * f_.coefficient_covariance * excess_b);
}

}  // namespace repose
