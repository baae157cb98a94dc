#include "calibration/parameter_range.h"

#include <cmath>

#include <fmt/core.h>

#include "base/error.h"

namespace repose {

Vector to_box(std::span<const ParameterRange> ranges, std::span<const double> values) {
  if (values.size() != ranges.size()) {
    throw DeckError(fmt::format("a point has {} values for {} parameters", values.size(), ranges.size()));
  }
  Vector point(static_cast<Index>(ranges.size()));
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const ParameterRange& range = ranges[i];
    if (!(range.upper > range.lower) || !std::isfinite(range.upper - range.lower)) {
      throw DeckError(fmt::format("parameter \"{}\": its range from {:g} to {:g} has no width", range.name, range.lower,
                                  range.upper));
    }
    if (!std::isfinite(values[i]))
      throw DeckError(fmt::format("parameter \"{}\": a run has no finite value", range.name));
    point[static_cast<Index>(i)] = (values[i] - range.lower) / (range.upper - range.lower);
  }
  return point;
}

std::vector<double> from_box(std::span<const ParameterRange> ranges, const Vector& point) {
  std::vector<double> values(ranges.size());
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    values[i] = ranges[i].lower + (ranges[i].upper - ranges[i].lower) * point[static_cast<Index>(i)];
  }
  return values;
}

Matrix to_box(std::span<const ParameterRange> ranges, std::span<const std::vector<double>> runs) {
  Matrix points(static_cast<Index>(runs.size()), static_cast<Index>(ranges.size()));
  for (std::size_t i = 0; i < runs.size(); ++i) {
    points.row(static_cast<Index>(i)) = to_box(ranges, runs[i]).transpose();
  }
  return points;
}

}  // namespace repose
