#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "calibration/replicates.h"
#include "calibration/transform.h"

namespace repose {

constexpr std::ptrdiff_t least_points = 4;  ///< that a surface takes

/// The runs of an observable on the scale of its transform. A row of `points` per run in units of the box; `values` are
/// in the observable's own units, NaN: the run has none. DeckError when fewer than least_points have a value, or one
/// that the transform does not take.
Replicates transformed_runs(const std::string& name, Transform transform, const Matrix& points,
                            std::span<const double> values);

/// What makes values about 0 with deviation 1.
struct Standard {
  double centre = 0.0;
  double scale = 1.0;
};

Standard standard_of(const Replicates& data);
Replicates standardised(Replicates data, const Standard& standard);

}  // namespace repose
