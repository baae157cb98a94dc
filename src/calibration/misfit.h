#pragma once

#include <span>
#include <string>
#include <vector>

#include "calibration/laboratory_value.h"
#include "calibration/parameter_range.h"
#include "calibration/response_surface.h"
#include "calibration/shared_noise.h"

namespace repose {

/// An observable: what the laboratory has, and what each run has, in the observable's units.
struct ObservableData {
  std::string name;
  Transform transform = Transform::none;
  LaboratoryValue laboratory;
  std::vector<double> values;  ///< one per run; NaN: the run has none (plugged, no pile)
};

/// How far the surfaces of all observables are from the laboratory, in standard deviations of the difference. Points
/// are in units of the box.
class Misfit {
 public:
  /// `runs` has the parameters of each run. DeckError when the sizes do not match, or a surface cannot be built.
  Misfit(std::vector<ParameterRange> ranges, std::span<const std::vector<double>> runs,
         std::span<const ObservableData> observables);

  /// T of (C.12): chi-squared with one degree of freedom per observable where the parameters are the true ones.
  double operator()(const Vector& point) const { return residuals(point).squaredNorm(); }
  /// Independent standard normal numbers at the true parameters (C.13); T is the sum of their squares.
  Vector residuals(const Vector& point) const;

  /// Surfaces less laboratory, one per observable, on the standardised scale.
  struct Look {
    Vector differences;
    Matrix covariance;  ///< of the differences (C.11)
  };
  Look look(const Vector& point) const;
  /// Derivatives of the differences, one row per observable.
  Matrix slopes(const Vector& point) const;

  const std::vector<ParameterRange>& ranges() const { return ranges_; }
  const std::vector<ResponseSurface>& surfaces() const { return surfaces_; }
  double laboratory_variance(std::size_t k) const { return targets_[k].variance; }  ///< standardised
  /// A row per run, in units of the box.
  const Matrix& runs() const { return runs_; }
  Index parameters() const { return static_cast<Index>(ranges_.size()); }
  Index observables() const { return static_cast<Index>(surfaces_.size()); }

 private:
  struct Target {
    double level;
    double variance;  ///< of the level
    double freedom;   ///< of the variance
  };
  std::vector<ParameterRange> ranges_;
  Matrix runs_;
  std::vector<ResponseSurface> surfaces_;
  std::vector<Target> targets_;
  std::vector<SharedNoise> shared_;
};

}  // namespace repose
