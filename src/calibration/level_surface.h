#pragma once

#include <span>
#include <string>

#include "calibration/level_process.h"
#include "calibration/observable_surface.h"
#include "calibration/standard_runs.h"

namespace repose {

struct RunLevels;

/// An observable over the parameters at the last of several levels of a model, from runs of all. The levels are
/// standardised each by itself, and rho is of those.
class LevelSurface : public ObservableSurface {
 public:
  /// As a ResponseSurface; DeckError when a level has fewer than four points with a value.
  LevelSurface(std::string name, Transform transform, const Matrix& points, std::span<const double> values,
               const RunLevels& levels);

  const std::string& name() const override { return name_; }
  double mean(const Vector& point) const override;
  double deviation(const Vector& point) const override;

  SurfaceValue at(const Vector& point) const override { return process_.at(point); }
  Vector gradient(const Vector& point) const override;
  double freedom(const Vector& point) const override { return process_.freedom(point); }
  double level_of(double value, const Vector& point) const override;
  double deviation_of(double level, double deviation, const Vector& point) const override;
  std::size_t levels() const override { return process_.levels(); }
  const Replicates& data(std::size_t level) const override { return process_.data(level); }
  double noise_variance(std::size_t level, const Vector& point) const override {
    return process_.parameters(level).noise_variance(point);
  }
  Matrix covariance(std::size_t level_a, const Matrix& a, std::size_t level_b, const Matrix& b) const override {
    return process_.covariance(level_a, a, level_b, b);
  }
  SurfaceValue at(const Vector& point, std::vector<NoiseWeights>& weights) const override;

  const LevelProcess& process() const { return process_; }
  /// rho between the scales of the transform, and its standard error: of what a level rises by where the one below
  /// rises by 1.
  double rho(std::size_t level) const { return process_.parameters(level).rho * ratio(level); }
  double rho_deviation(std::size_t level) const { return process_.rho_deviation(level) * ratio(level); }
  /// The share of a level's variance over the box that rho times the level below explains: 1 - var(what is added) /
  /// var.
  double explained(std::size_t level) const;

 private:
  LevelSurface(std::string name, Transform transform, std::vector<Replicates> levels);
  double noise_on_scale(const Vector& point) const;
  double ratio(std::size_t level) const { return standards_[level].scale / standards_[level - 1].scale; }

  std::string name_;
  Transform transform_;
  std::vector<Standard> standards_;
  LevelProcess process_;
};

}  // namespace repose
