#include "calibration/replicates.h"

#include <cmath>

namespace repose {
namespace {

constexpr double same_point = 1e-9;  // of the box

/// The row of `points` that is `point`, or -1.
Index find_point(const Matrix& points, Index rows, const Eigen::RowVectorXd& point) {
  for (Index i = 0; i < rows; ++i) {
    if ((points.row(i) - point).cwiseAbs().maxCoeff() < same_point) return i;
  }
  return -1;
}

}  // namespace

Replicates replicates_of(const Matrix& points, std::span<const double> values) {
  Replicates result;
  result.points.resize(points.rows(), points.cols());
  result.point_of_run.assign(values.size(), -1);
  Vector sum = Vector::Zero(points.rows());
  Vector count = Vector::Zero(points.rows());
  Index found = 0;
  for (std::size_t run = 0; run < values.size(); ++run) {
    if (std::isnan(values[run])) continue;
    const Eigen::RowVectorXd point = points.row(static_cast<Index>(run));
    Index at = find_point(result.points, found, point);
    if (at < 0) {
      at = found++;
      result.points.row(at) = point;
    }
    result.point_of_run[run] = at;
    sum[at] += values[run];
    count[at] += 1.0;
  }
  result.points.conservativeResize(found, Eigen::NoChange);
  result.count = count.head(found);
  result.mean = sum.head(found).cwiseQuotient(result.count);
  // Deviations from the means in a second pass: differences of sums of squares would lose their digits.
  result.rest_of_run.assign(values.size(), 0.0);
  for (std::size_t run = 0; run < values.size(); ++run) {
    const Index at = result.point_of_run[run];
    if (at < 0) continue;
    const double rest = values[run] - result.mean[at];
    result.rest_of_run[run] = rest;
    result.squares_within += rest * rest;
    result.freedom_within += 1.0;
  }
  result.freedom_within -= static_cast<double>(found);
  return result;
}

}  // namespace repose
