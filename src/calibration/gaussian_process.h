#pragma once

#include "calibration/likelihood.h"
#include "calibration/linear_algebra.h"
#include "calibration/matern_kernel.h"
#include "calibration/replicates.h"

namespace repose {

/// What a Gaussian process says of its surface, not of a new run.
struct SurfaceValue {
  double mean = 0.0;
  double deviation = 0.0;
};

/// A Gaussian process through the means of runs at points of the unit box (Rasmussen and Williams 2006, chapter 2;
/// docs/theory.md, "Calibration"). Mean: a plane, or a constant where the points do not bear one.
class GaussianProcess {
 public:
  /// With the most likely hyperparameters. Needs at least four points.
  explicit GaussianProcess(Replicates data);
  GaussianProcess(Replicates data, const Hyperparameters& hyperparameters);

  SurfaceValue at(const Vector& point) const { return look(point).value; }
  /// The same, and `weights`, in less than the time of both.
  SurfaceValue at(const Vector& point, Vector& weights) const;
  Vector gradient(const Vector& point) const;  ///< of the mean
  /// What the surface's mean at `point` takes of the mean at each of the data's points.
  Vector weights(const Vector& point) const;
  /// Covariance of the surface at the rows of `a` (down) with that at the rows of `b` (across).
  Matrix covariance(const Matrix& a, const Matrix& b) const;

  const Replicates& data() const { return data_; }
  double noise_variance() const { return f_.signal_variance * hyperparameters_.noise_ratio; }  ///< of one run
  double signal_variance() const { return f_.signal_variance; }
  double freedom() const { return f_.freedom; }  ///< degrees of freedom of both variances

 private:
  /// The surface at a point, and what its weights take besides.
  struct Look {
    SurfaceValue value;
    Vector excess;  ///< of the terms of the mean over what the data have of them
    Vector half;    ///< the kernel to the data, over the root of their covariance
  };
  Look look(const Vector& point) const;

  Replicates data_;
  bool linear_;
  Hyperparameters hyperparameters_;
  MaternKernel kernel_;
  Factors f_;
};

}  // namespace repose
