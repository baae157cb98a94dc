#pragma once

#include <vector>

#include "calibration/linear_algebra.h"
#include "calibration/replicates.h"

namespace repose {

/// What shapes a Gaussian process, apart from its signal variance, which follows from the data in closed form.
struct Hyperparameters {
  Vector lengths;            ///< of the kernel, in units of the box
  double noise_ratio = 0.0;  ///< variance of one run over the signal variance
};

/// The prior of the logarithm of the noise ratio, normal as those of (C.5): 1 %, widely.
inline constexpr double usual_log_noise = -4.6;
inline constexpr double log_noise_scatter = 4.0;

/// The terms of the mean at each row of `points`: 1 and the parameters about the middle of the box.
Matrix mean_terms(const Matrix& points, bool linear);

/// Whether a plane can be the mean: with few points its slopes would take all that they say, and points that lie on a
/// line of the box tell no slope across it.
bool bears_plane(const Replicates& data);

/// The parts of a Gaussian process with given hyperparameters, all over the signal variance.
struct Factors {
  Eigen::LLT<Matrix> covariance;  ///< of the means at the points: kernel and noise
  Matrix terms;                   ///< of the mean
  Matrix weighted_terms;          ///< covariance^-1 terms
  Matrix coefficient_covariance;  ///< (terms^T covariance^-1 terms)^-1
  Vector coefficients;            ///< of the mean, by generalised least squares
  Vector weights;                 ///< covariance^-1 (values - mean)
  double signal_variance = 0.0;
  double freedom = 0.0;  ///< degrees of freedom of the signal variance
};

Factors factorise(const Replicates& data, const Hyperparameters& hyperparameters, bool linear);

/// -2 ln of the restricted likelihood of all runs, maximal in the signal variance, less the logarithm of the prior of
/// the hyperparameters, over (ln lengths, ln noise ratio); its gradient in `gradient` (C.5, C.6).
double penalised_deviance(const Replicates& data, const Vector& log_parameters, bool linear, Vector& gradient);

/// The hyperparameters at a place of the deviance.
Hyperparameters hyperparameters_at(const Vector& log_parameters);

/// Those of the least deviance found from a fixed set of starting points.
Hyperparameters most_likely(const Replicates& data, bool linear);

}  // namespace repose
