#pragma once

#include <cmath>

namespace repose::fields {

/// The integral from minus infinity to `u` of the cubic B-spline with knots at -2, -1, 0, 1 and 2: 0 before them, 1
/// behind them (docs/theory.md, "Coarse-grained fields").
inline double spline_below(double u) {
  if (u <= -2.0) return 0.0;
  if (u >= 2.0) return 1.0;
  const double a = std::fabs(u);
  const double rest = 2.0 - a;
  const double beyond =
      a >= 1.0 ? rest * rest * rest * rest / 24.0 : 0.5 - a * (2.0 / 3.0 - a * a * (1.0 / 3.0 - a / 8.0));
  return u < 0.0 ? beyond : 1.0 - beyond;
}

/// The share of the kernel of half-width `width` (m) about 0 that lies below `x` (m), in one direction.
inline double kernel_below(double x, double width) { return spline_below(2.0 * x / width); }

}  // namespace repose::fields
