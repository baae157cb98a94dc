#pragma once

#include <span>
#include <string>
#include <vector>

#include "calibration/linear_algebra.h"
#include "calibration/prior.h"

namespace repose {

/// A parameter and where it is looked for, in its own units.
struct ParameterRange {
  std::string name;
  double lower = 0.0;
  double upper = 1.0;
  Prior prior = {};
};

/// Parameters to units of the box, 0 at the lower end of each range and 1 at the upper, and back. DeckError when the
/// numbers of parameters differ or a range has no width.
Vector to_box(std::span<const ParameterRange> ranges, std::span<const double> values);
std::vector<double> from_box(std::span<const ParameterRange> ranges, const Vector& point);

/// The same for a row per run.
Matrix to_box(std::span<const ParameterRange> ranges, std::span<const std::vector<double>> runs);

}  // namespace repose
