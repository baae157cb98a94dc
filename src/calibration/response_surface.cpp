#include "calibration/response_surface.h"

#include <cmath>
#include <utility>

namespace repose {

ResponseSurface::ResponseSurface(std::string name, Transform transform, const Replicates& data,
                                 const Standard& standard)
    : name_(std::move(name)), transform_(transform), standard_(standard), process_(standardised(data, standard)) {}

ResponseSurface::ResponseSurface(std::string name, Transform transform, const Matrix& points,
                                 std::span<const double> values)
    : ResponseSurface([&] {
        const Replicates runs = transformed_runs(name, transform, points, values);
        return ResponseSurface(name, transform, runs, standard_of(runs));
      }()) {}

double ResponseSurface::scale_value_at(const Vector& point) const {
  return standard_.centre + standard_.scale * process_.at(point).mean;
}

double ResponseSurface::mean(const Vector& point) const {
  return mean_in_units(transform_, scale_value_at(point), noise_on_scale());
}

double ResponseSurface::deviation(const Vector& point) const {
  return standard_.scale * process_.at(point).deviation /
         slope_of_transform(transform_, scale_value_at(point), noise_on_scale());
}

double ResponseSurface::noise_deviation(const Vector& point) const {
  return std::sqrt(noise_on_scale()) / slope_of_transform(transform_, scale_value_at(point), noise_on_scale());
}

double ResponseSurface::scaled_level(double value) const {
  return (transformed_mean(transform_, value, noise_on_scale()) - standard_.centre) / standard_.scale;
}

double ResponseSurface::scaled_deviation(double level, double deviation) const {
  const double mean = standard_.centre + standard_.scale * level;
  return deviation * slope_of_transform(transform_, mean, noise_on_scale()) / standard_.scale;
}

}  // namespace repose
