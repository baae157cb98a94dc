#pragma once

#include <initializer_list>
#include <vector>

#include "calibration/replicates.h"

namespace repose {

/// A row per point.
inline Matrix rows(std::initializer_list<std::initializer_list<double>> points) {
  Matrix result(static_cast<Index>(points.size()), static_cast<Index>(points.begin()->size()));
  Index i = 0;
  for (const auto& point : points) {
    Index j = 0;
    for (const double x : point) result(i, j++) = x;
    ++i;
  }
  return result;
}

inline Vector vector_of(std::initializer_list<double> values) {
  Vector result(static_cast<Index>(values.size()));
  Index i = 0;
  for (const double value : values) result[i++] = value;
  return result;
}

/// A grid of `side` by `side` points of the unit box, each `times` times.
inline Matrix unit_grid(Index side, Index times = 1) {
  Matrix points(side * side * times, 2);
  for (Index run = 0; run < points.rows(); ++run) {
    const Index node = run / times;
    points(run, 0) = static_cast<double>(node % side) / static_cast<double>(side - 1);
    points(run, 1) = static_cast<double>(node / side) / static_cast<double>(side - 1);
  }
  return points;
}

/// What a function of two parameters gives at each row.
template <class Function>
std::vector<double> values_at(const Matrix& points, const Function& function) {
  std::vector<double> values;
  for (Index i = 0; i < points.rows(); ++i) values.push_back(function(points(i, 0), points(i, 1)));
  return values;
}

}  // namespace repose
