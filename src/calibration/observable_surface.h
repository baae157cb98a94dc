#pragma once

#include <string>
#include <vector>

#include "calibration/gaussian_process.h"

namespace repose {

/// What the mean of a surface takes of the means at the points of a level, and the variance of one run there.
struct NoiseWeights {
  Vector weights;
  double variance = 1.0;
};

/// The surface of an observable as the misfit and the search ask for it: over one level of a model or several, of which
/// the last one counts. Points are in units of the box (0 to 1 in each parameter).
class ObservableSurface {
 public:
  virtual ~ObservableSurface() = default;

  virtual const std::string& name() const = 0;
  virtual double mean(const Vector& point) const = 0;       ///< in units: what runs there give in the mean
  virtual double deviation(const Vector& point) const = 0;  ///< in units: standard deviation of `mean`

  // On the scale on which the surface was built, standardised.
  virtual SurfaceValue at(const Vector& point) const = 0;
  virtual Vector gradient(const Vector& point) const = 0;
  virtual double freedom(const Vector& point) const = 0;                 ///< degrees of freedom of the variance
  virtual double level_of(double value, const Vector& point) const = 0;  ///< of a mean in units
  virtual double deviation_of(double level, double deviation, const Vector& point) const = 0;  ///< of one in units

  virtual std::size_t levels() const = 0;
  virtual const Replicates& data(std::size_t level) const = 0;
  virtual double noise_variance(std::size_t level, const Vector& point) const = 0;  ///< of one run
  /// Of two levels' surfaces, given all runs: at the rows of `a` (down) with those of `b` (across).
  virtual Matrix covariance(std::size_t level_a, const Matrix& a, std::size_t level_b, const Matrix& b) const = 0;
  /// `at`, and what it takes of each level in `weights`.
  virtual SurfaceValue at(const Vector& point, std::vector<NoiseWeights>& weights) const = 0;
};

}  // namespace repose
