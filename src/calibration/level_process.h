#pragma once

#include <memory>
#include <span>
#include <vector>

#include "calibration/gaussian_process.h"
#include "calibration/level_parameters.h"

namespace repose {

/// Autoregressive Gaussian process over levels of a model, the cheapest first: each is rho times the one below, and a
/// process of its own (Kennedy and O'Hagan 2000, doi:10.1093/biomet/87.1.1; the parameters of a level given those
/// below, and rho among the coefficients of the mean: Le Gratiet and Garnier 2014,
/// doi:10.1615/Int.J.UncertaintyQuantification.2014006914; docs/theory.md, "Levels"). Points of the levels need not
/// coincide. The surface is that of the last level.
class LevelProcess {
 public:
  /// With the most likely parameters of each level. Needs four points at each.
  explicit LevelProcess(std::vector<Replicates> levels);
  LevelProcess(std::vector<Replicates> levels, std::vector<LevelParameters> parameters);

  SurfaceValue at(const Vector& point) const;
  double mean(const Vector& point) const;
  /// What the surface's mean takes of the mean at each point, level after level.
  std::vector<Vector> weights(const Vector& point) const;
  /// Covariance of the surface of a level at the rows of `a` (down) with that of another at the rows of `b` (across),
  /// given all runs.
  Matrix covariance(std::size_t level_a, const Matrix& a, std::size_t level_b, const Matrix& b) const;

  std::size_t levels() const { return data_.size(); }
  const Replicates& data(std::size_t level) const { return data_[level]; }
  const LevelParameters& parameters(std::size_t level) const { return parameters_[level]; }
  /// The levels below and including one, from their own runs alone.
  const LevelProcess& up_to(std::size_t level) const { return level + 1 == levels() ? *this : *below_[level]; }
  double rho_deviation(std::size_t level) const;  ///< standard error of a level's rho
  /// Degrees of freedom of the surface's variance at a point: of what the level below leaves open and of what the last
  /// level adds, each with its own (C.28).
  double freedom(const Vector& point) const;

 private:
  void add_level(Replicates data, const LevelParameters& parameters);
  void factorise();
  /// What level `of` takes of the process that `added` adds: the product of the rhos between.
  double share(std::size_t added, std::size_t of) const;
  /// Before any run: covariance of the levels.
  Matrix prior(std::size_t level_a, const Matrix& a, std::size_t level_b, const Matrix& b) const;
  Matrix prior_with_data(std::size_t level, const Matrix& a) const;  ///< across: all points of all levels
  Matrix terms(std::size_t level, const Matrix& points) const;
  double prior_variance() const;  ///< of the last level

  std::vector<Replicates> data_;
  std::vector<LevelParameters> parameters_;
  std::vector<std::shared_ptr<const LevelProcess>> below_;  ///< up to each level but the last
  std::vector<char> linear_;
  std::vector<Index> rho_column_;
  Index columns_ = 0;
  Eigen::LLT<Matrix> covariance_;  ///< of the means at all points
  Matrix weighted_terms_;
  Matrix coefficient_covariance_;
  Vector coefficients_;
  Vector weights_;
  double freedom_ = 0.0;
};

}  // namespace repose
