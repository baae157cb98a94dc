#pragma once

#include <span>
#include <string>

#include "calibration/laboratory_value.h"
#include "calibration/observable_surface.h"
#include "calibration/parameter_range.h"
#include "calibration/standard_runs.h"

namespace repose {

/// An observable over the parameters, from runs of one level.
class ResponseSurface : public ObservableSurface {
 public:
  /// `points` has a row per run in units of the box; `values` are in the observable's own units, NaN: the run has none.
  /// DeckError when fewer than four points have a value, or one that the transform does not take.
  ResponseSurface(std::string name, Transform transform, const Matrix& points, std::span<const double> values);

  const std::string& name() const override { return name_; }
  double mean(const Vector& point) const override;
  double deviation(const Vector& point) const override;
  double noise_deviation(const Vector& point) const;  ///< in units: of one run there, from seed to seed

  /// On the scale on which the surface was built, standardised.
  const GaussianProcess& process() const { return process_; }
  double scaled_level(double value) const;                        ///< of a mean in units
  double scaled_deviation(double level, double deviation) const;  ///< of a deviation in units, at a scaled level

  SurfaceValue at(const Vector& point) const override { return process_.at(point); }
  Vector gradient(const Vector& point) const override { return process_.gradient(point); }
  double freedom(const Vector&) const override { return process_.freedom(); }
  double level_of(double value, const Vector& /*point*/) const override { return scaled_level(value); }
  double deviation_of(double level, double deviation, const Vector& /*point*/) const override {
    return scaled_deviation(level, deviation);
  }
  std::size_t levels() const override { return 1; }
  const Replicates& data(std::size_t /*level*/) const override { return process_.data(); }
  double noise_variance(std::size_t /*level*/, const Vector& /*point*/) const override {
    return process_.noise_variance();
  }
  Matrix covariance(std::size_t /*level_a*/, const Matrix& a, std::size_t /*level_b*/, const Matrix& b) const override {
    return process_.covariance(a, b);
  }
  SurfaceValue at(const Vector& point, std::vector<NoiseWeights>& weights) const override {
    weights = {{{}, process_.noise_variance()}};
    return process_.at(point, weights.front().weights);
  }

 private:
  ResponseSurface(std::string name, Transform transform, const Replicates& data, const Standard& standard);

  /// On the transform's scale, not standardised.
  double scale_value_at(const Vector& point) const;
  double noise_on_scale() const { return standard_.scale * standard_.scale * process_.noise_variance(); }

  std::string name_;
  Transform transform_;
  Standard standard_;
  GaussianProcess process_;
};

}  // namespace repose
