#include "calibration/level_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "calibration/lattice.h"
#include "calibration/misfit.h"
#include "calibration/posterior_estimate.h"

namespace repose {
namespace {

std::vector<Replicates> split(const std::string& name, Transform transform, const Matrix& points,
                              std::span<const double> values, const RunLevels& levels) {
  std::vector<Replicates> result;
  for (std::size_t level = 0; level < levels.count; ++level) {
    std::vector<double> own(values.begin(), values.end());
    for (std::size_t run = 0; run < own.size(); ++run) {
      if (levels.of_run[run] != level) own[run] = std::numeric_limits<double>::quiet_NaN();
    }
    result.push_back(transformed_runs(name, transform, points, own));
  }
  return result;
}

/// A search puts points where the estimate is; their range, unlike their deviation, remains that of the first design.
std::vector<Standard> standards_of(const std::vector<Replicates>& levels) {
  std::vector<Standard> result;
  for (const Replicates& level : levels) {
    Standard& standard = result.emplace_back(standard_of(level));
    const double range = level.mean.maxCoeff() - level.mean.minCoeff();
    standard.scale = std::max(standard.scale, range / std::sqrt(12.0));  // the deviation of what is spread evenly
  }
  return result;
}

std::vector<Replicates> all_standardised(std::vector<Replicates> levels, const std::vector<Standard>& standards) {
  for (std::size_t k = 0; k < levels.size(); ++k) levels[k] = standardised(std::move(levels[k]), standards[k]);
  return levels;
}

}  // namespace

LevelSurface::LevelSurface(std::string name, Transform transform, std::vector<Replicates> levels)
    : name_(std::move(name)),
      transform_(transform),
      standards_(standards_of(levels)),
      process_(all_standardised(std::move(levels), standards_)) {}

LevelSurface::LevelSurface(std::string name, Transform transform, const Matrix& points, std::span<const double> values,
                           const RunLevels& levels)
    : LevelSurface(name, transform, split(name, transform, points, values, levels)) {}

double LevelSurface::noise_on_scale(const Vector& point) const {
  const double scale = standards_.back().scale;
  return scale * scale * noise_variance(levels() - 1, point);
}

double LevelSurface::mean(const Vector& point) const {
  const Standard& standard = standards_.back();
  return mean_in_units(transform_, standard.centre + standard.scale * process_.mean(point), noise_on_scale(point));
}

double LevelSurface::deviation(const Vector& point) const {
  const Standard& standard = standards_.back();
  const SurfaceValue value = process_.at(point);
  return standard.scale * value.deviation /
         slope_of_transform(transform_, standard.centre + standard.scale * value.mean, noise_on_scale(point));
}

Vector LevelSurface::gradient(const Vector& point) const {
  constexpr double step = 1e-5;  // of the box
  Vector result(point.size());
  for (Index j = 0; j < point.size(); ++j) {
    Vector before = point;
    Vector after = point;
    before[j] -= step;
    after[j] += step;
    result[j] = (process_.mean(after) - process_.mean(before)) / (2.0 * step);
  }
  return result;
}

double LevelSurface::level_of(double value, const Vector& point) const {
  const Standard& standard = standards_.back();
  return (transformed_mean(transform_, value, noise_on_scale(point)) - standard.centre) / standard.scale;
}

double LevelSurface::deviation_of(double level, double deviation, const Vector& point) const {
  const Standard& standard = standards_.back();
  const double mean = standard.centre + standard.scale * level;
  return deviation * slope_of_transform(transform_, mean, noise_on_scale(point)) / standard.scale;
}

double LevelSurface::explained(std::size_t level) const {
  constexpr std::array<Index, most_parameters + 1> sides = {0, 101, 21, 9, 5, 4, 4};
  const Index d = data(0).points.cols();
  const BoxLattice lattice = unit_lattice(d, sides.at(static_cast<std::size_t>(d)));
  Vector whole(lattice.size());
  Vector added(lattice.size());
  for (Index node = 0; node < lattice.size(); ++node) {
    const Vector point = lattice.point(node);
    whole[node] = process_.up_to(level).mean(point);
    added[node] = whole[node] - process_.parameters(level).rho * process_.up_to(level - 1).mean(point);
  }
  const auto variance = [](const Vector& v) { return (v.array() - v.mean()).square().mean(); };
  return variance(whole) > 0.0 ? std::max(0.0, 1.0 - variance(added) / variance(whole)) : 0.0;
}

SurfaceValue LevelSurface::at(const Vector& point, std::vector<NoiseWeights>& weights) const {
  std::vector<Vector> own = process_.weights(point);
  weights.clear();
  for (std::size_t level = 0; level < levels(); ++level) {
    const Matrix& points = data(level).points;
    for (Index i = 0; i < points.rows(); ++i) {
      own[level][i] *= std::sqrt(noise_variance(level, points.row(i).transpose()));
    }
    weights.push_back({std::move(own[level]), 1.0});
  }
  return process_.at(point);
}

}  // namespace repose
