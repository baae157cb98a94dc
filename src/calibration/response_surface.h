#pragma once

#include <span>
#include <string>

#include "calibration/gaussian_process.h"
#include "calibration/laboratory_value.h"
#include "calibration/parameter_range.h"
#include "calibration/transform.h"

namespace repose {

/// An observable over the parameters, from runs. Points are in units of the box (0 to 1 in each parameter).
class ResponseSurface {
 public:
  /// `points` has a row per run in units of the box; `values` are in the observable's own units, NaN: the run has none.
  /// DeckError when fewer than four points have a value, or one that the transform does not take.
  ResponseSurface(std::string name, Transform transform, const Matrix& points, std::span<const double> values);

  double mean(const Vector& point) const;             ///< in units: what runs there give in the mean
  double deviation(const Vector& point) const;        ///< in units: standard deviation of `mean`
  double noise_deviation(const Vector& point) const;  ///< in units: of one run there, from seed to seed

  /// On the scale on which the surface was built, standardised.
  const GaussianProcess& process() const { return process_; }
  double scaled_level(double value) const;                        ///< of a mean in units
  double scaled_deviation(double level, double deviation) const;  ///< of a deviation in units, at a scaled level

  const std::string& name() const { return name_; }

 private:
  struct Standard {
    double centre;
    double scale;
  };
  static Standard standard_of(const Replicates& data);
  static Replicates standardised(Replicates data, const Standard& standard);
  ResponseSurface(std::string name, Transform transform, const Replicates& data, const Standard& standard);

  /// On the transform's scale, not standardised.
  double level_at(const Vector& point) const;
  double noise_variance() const { return standard_.scale * standard_.scale * process_.noise_variance(); }

  std::string name_;
  Transform transform_;
  Standard standard_;
  GaussianProcess process_;
};

}  // namespace repose
