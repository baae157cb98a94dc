#include "calibration/standard_runs.h"

#include <cmath>
#include <vector>

#include <fmt/core.h>

#include "base/error.h"

namespace repose {

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

Standard standard_of(const Replicates& data) {
  const double centre = data.mean.mean();
  const double variance = (data.mean.array() - centre).square().mean() + data.squares_within / data.count.sum();
  // Values that are all equal have no scale of their own; any is right.
  const bool equal = !(variance > 1e-24 * centre * centre);
  return {.centre = centre, .scale = equal ? (centre == 0.0 ? 1.0 : std::fabs(centre)) : std::sqrt(variance)};
}

Replicates standardised(Replicates data, const Standard& standard) {
  data.mean = (data.mean.array() - standard.centre) / standard.scale;
  data.squares_within /= standard.scale * standard.scale;
  for (double& rest : data.rest_of_run) rest /= standard.scale;
  return data;
}

}  // namespace repose
