#pragma once

#include <functional>

#include "calibration/linear_algebra.h"

namespace repose {

/// Smooth residuals at a point of the unit box; what is looked for is where the sum of their squares, T, is least.
using Residuals = std::function<Vector(const Vector& point)>;

struct LeastSquares {
  Vector point;
  double squares = 0.0;  ///< T there
};

/// A local minimum of T in the unit box by Levenberg's and Marquardt's method (Marquardt 1963, doi:10.1137/0111030),
/// from `start` and nowhere above it. Parameter `held` keeps its value (none: -1). Derivatives by central differences.
LeastSquares descend(const Residuals& residuals, const Vector& start, Index held = -1);

}  // namespace repose
