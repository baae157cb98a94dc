#pragma once

#include <functional>
#include <vector>

namespace repose {

struct PlanePoint {
  double x = 0.0;
  double y = 0.0;
};

/// A polyline; closed when its last point is its first.
using ContourLine = std::vector<PlanePoint>;

struct PlaneRange {
  double lower = 0.0;
  double upper = 1.0;
};

/// The lines along which `surface` has the value `level`, over a rectangle: marching squares on `cells` by `cells`
/// cells, each crossing of a cell's side found on the surface itself within 1e-6 of the side. Open lines end at the
/// edge of the rectangle. The surface may be NaN in places: lines end there.
std::vector<ContourLine> contour_lines(const std::function<double(double x, double y)>& surface, PlaneRange x,
                                       PlaneRange y, double level, int cells = 100);

}  // namespace repose
