#pragma once

#include <span>
#include <vector>

#include "calibration/linear_algebra.h"

namespace repose {

/// Runs at the same point are kept as their mean and number, and all of them together as their scatter within the
/// points. That is all a Gaussian process asks of them, so its cost goes with the number of points, not of runs.
struct Replicates {
  Matrix points;                    ///< one row per point, in units of the box (0 to 1)
  Vector mean;                      ///< of the runs at each point
  Vector count;                     ///< of the runs at each point
  double squares_within = 0.0;      ///< sum of (value - mean of its point)^2 over all runs
  double freedom_within = 0.0;      ///< runs less points
  std::vector<Index> point_of_run;  ///< -1: the run has no value
  std::vector<double> rest_of_run;  ///< value less the mean of its point; 0 without a value

  Index size() const { return points.rows(); }
  /// Runs beside the first of their point: `freedom_within` as a count.
  Index second_seeds() const { return static_cast<Index>(freedom_within); }
};

/// Puts runs together whose points differ by less than 1e-9 of the box in each parameter. `points` has a row per run;
/// a value that is NaN is left out. Points stand in the order of their first run.
Replicates replicates_of(const Matrix& points, std::span<const double> values);

}  // namespace repose
