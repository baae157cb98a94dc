#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "calibration/laboratory_value.h"
#include "calibration/observable_surface.h"
#include "calibration/parameter_range.h"
#include "calibration/shared_noise.h"
#include "calibration/transform.h"

namespace repose {

/// An observable: what the laboratory has, and what each run has, in the observable's units.
struct ObservableData {
  std::string name;
  Transform transform = Transform::none;
  LaboratoryValue laboratory;
  std::vector<double> values;  ///< one per run; NaN: the run has none (plugged, no pile)
  double discrepancy = 0.0;    ///< standard deviation of what the model cannot be expected to meet
  std::size_t experiment = 0;  ///< whose runs have it
};

/// Of which level of the model each run is, the cheapest first, and of which experiment. The last level is the one that
/// counts.
struct RunLevels {
  std::size_t count = 1;
  std::vector<std::size_t> of_run = {};             ///< empty: there is one level
  std::vector<std::size_t> experiment_of_run = {};  ///< empty: there is one experiment
};

/// How far the surfaces of all observables are from the laboratory, in standard deviations of the difference. Points
/// are in units of the box.
class Misfit {
 public:
  /// `runs` has the parameters of each run. DeckError when the sizes do not match, or a surface cannot be built.
  Misfit(std::vector<ParameterRange> ranges, std::span<const std::vector<double>> runs,
         std::span<const ObservableData> observables);
  /// The same over levels of a model; DeckError also when a level has no surface.
  Misfit(std::vector<ParameterRange> ranges, std::span<const std::vector<double>> runs, RunLevels levels,
         std::span<const ObservableData> observables);

  /// T of (C.12): chi-squared with one degree of freedom per observable where the parameters are the true ones.
  double operator()(const Vector& point) const { return residuals(point).squaredNorm(); }
  /// Independent standard normal numbers at the true parameters (C.13); T is the sum of their squares.
  Vector residuals(const Vector& point) const;
  /// ln of the density of the laboratory's values at these parameters, up to a constant (C.31).
  double log_likelihood(const Vector& point) const;

  /// Surfaces less laboratory, one per observable, on the standardised scale.
  struct Look {
    Vector differences;
    Matrix covariance;  ///< of the differences (C.11)
  };
  Look look(const Vector& point) const;
  /// Derivatives of the differences, one row per observable.
  Matrix slopes(const Vector& point) const;

  const std::vector<ParameterRange>& ranges() const { return ranges_; }
  const ObservableSurface& surface(Index k) const { return *surfaces_[static_cast<std::size_t>(k)]; }
  /// Of the laboratory and the model's discrepancy, standardised: no run narrows it.
  double least_variance(Index k, const Vector& point) const;
  /// A row per run, in units of the box.
  const Matrix& runs() const { return runs_; }
  std::size_t levels() const { return levels_.count; }
  /// The level of a run.
  std::size_t level_of(Index run) const {
    return levels_.count == 1 ? 0 : levels_.of_run[static_cast<std::size_t>(run)];
  }
  /// To which an observable belongs.
  std::size_t experiment(Index k) const { return experiment_[static_cast<std::size_t>(k)]; }
  /// Whether a run is of the experiment of an observable.
  bool is_asked(Index run, Index k) const {
    return levels_.experiment_of_run.empty() ||
           levels_.experiment_of_run[static_cast<std::size_t>(run)] == experiment(k);
  }
  Index parameters() const { return static_cast<Index>(ranges_.size()); }
  Index observables() const { return static_cast<Index>(surfaces_.size()); }

 private:
  /// What the laboratory has, on the scale of a surface.
  struct Target {
    double level;
    double variance;     ///< of the level
    double discrepancy;  ///< variance of the model's
  };
  Target target(std::size_t k, const Vector& point) const;
  struct Residual {
    Vector values;
    double log_slope;  ///< ln |d values / d laboratory|
  };
  Residual residual(const Vector& point) const;
  void share_noise();

  std::vector<ParameterRange> ranges_;
  Matrix runs_;
  RunLevels levels_;
  std::vector<std::shared_ptr<const ObservableSurface>> surfaces_;
  std::vector<LaboratoryValue> laboratory_;
  std::vector<double> discrepancy_;               ///< in units
  std::vector<std::size_t> experiment_;           ///< of each observable
  std::vector<std::vector<SharedNoise>> shared_;  ///< of each pair of surfaces, one per level
  std::vector<bool> shares_noise_;                ///< of each surface: with another
};

}  // namespace repose
