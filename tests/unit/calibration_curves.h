#pragma once

#include <cmath>
#include <vector>

#include "calibration/curve_components.h"
#include "calibration_stand_ins.h"

namespace repose {

inline void add_curve(std::vector<CurveRun>& runs, std::size_t point, const Vector& y) {
  CurveRun& run = runs.emplace_back();
  run.point = point;
  run.y = y;
}

/// Draws of curves.
struct CurveDraw : Draw {
  using Draw::Draw;
  /// Of variance 1, with the correlation exp(-distance / length).
  Vector correlated(const Vector& x, double length) {
    Vector e(x.size());
    for (Index j = 0; j < x.size(); ++j) {
      const double rho = j == 0 ? 0.0 : std::exp(-(x[j] - x[j - 1]) / length);
      e[j] = (j == 0 ? 0.0 : rho * e[j - 1]) + std::sqrt(1.0 - rho * rho) * normal();
    }
    return e;
  }
};

}  // namespace repose
