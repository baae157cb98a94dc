#include "calibration/response_surface.h"

#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/error.h"

namespace repose {
namespace {

constexpr Index least_points = 4;

Replicates transformed_runs(const std::string& name, Transform transform, const Matrix& points,
                            std::span<const double> values) {
  std::vector<double> scaled(values.begin(), values.end());
  for (double& value : scaled) {
    if (std::isnan(value)) continue;
    const double given = value;
    value = transformed(transform, value);
    if (!std::isfinite(value)) {
      throw DeckError(
          fmt::format("observable \"{}\": a run has the value {:g}, which its transform does not take", name, given));
    }
  }
  Replicates runs = replicates_of(points, scaled);
  if (runs.size() < least_points) {
    throw DeckError(fmt::format("observable \"{}\": has a value at {} points; a surface needs {} or more", name,
                                runs.size(), least_points));
  }
  return runs;
}

}  // namespace

ResponseSurface::Standard ResponseSurface::standard_of(const Replicates& data) {
  const double centre = data.mean.mean();
  const double variance = (data.mean.array() - centre).square().mean() + data.squares_within / data.count.sum();
  // Values that are all equal have no scale of their own; any is right.
  const bool equal = !(variance > 1e-24 * centre * centre);
  return {.centre = centre, .scale = equal ? (centre == 0.0 ? 1.0 : std::fabs(centre)) : std::sqrt(variance)};
}

Replicates ResponseSurface::standardised(Replicates data, const Standard& standard) {
  data.mean = (data.mean.array() - standard.centre) / standard.scale;
  data.squares_within /= standard.scale * standard.scale;
  for (double& rest : data.rest_of_run) rest /= standard.scale;
  return data;
}

ResponseSurface::ResponseSurface(std::string name, Transform transform, const Replicates& data,
                                 const Standard& standard)
    : name_(std::move(name)), transform_(transform), standard_(standard), process_(standardised(data, standard)) {}

ResponseSurface::ResponseSurface(std::string name, Transform transform, const Matrix& points,
                                 std::span<const double> values)
    : ResponseSurface([&] {
        const Replicates runs = transformed_runs(name, transform, points, values);
        return ResponseSurface(name, transform, runs, standard_of(runs));
      }()) {}

double ResponseSurface::level_at(const Vector& point) const {
  return standard_.centre + standard_.scale * process_.at(point).mean;
}

double ResponseSurface::mean(const Vector& point) const {
  return mean_in_units(transform_, level_at(point), noise_variance());
}

double ResponseSurface::deviation(const Vector& point) const {
  return standard_.scale * process_.at(point).deviation /
         slope_of_transform(transform_, level_at(point), noise_variance());
}

double ResponseSurface::noise_deviation(const Vector& point) const {
  return std::sqrt(noise_variance()) / slope_of_transform(transform_, level_at(point), noise_variance());
}

double ResponseSurface::scaled_level(double value) const {
  return (transformed_mean(transform_, value, noise_variance()) - standard_.centre) / standard_.scale;
}

double ResponseSurface::scaled_deviation(double level, double deviation) const {
  const double mean = standard_.centre + standard_.scale * level;
  return deviation * slope_of_transform(transform_, mean, noise_variance()) / standard_.scale;
}

}  // namespace repose
