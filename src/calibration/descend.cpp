#include "calibration/descend.h"

#include <algorithm>
#include <vector>

namespace repose {
namespace {

constexpr int max_iterations = 60;
constexpr double difference = 1e-5;   // of the box
constexpr double least_step = 1e-10;  // of the box
constexpr double no_gain = 1e-10;     // of T, relative
constexpr double zero = 1e-22;        // a T that is none

/// By central differences, at an edge of the box by those to one side: beyond it there may be no residuals.
Matrix jacobian(const Residuals& residuals, const Vector& point) {
  Matrix result;
  for (Index j = 0; j < point.size(); ++j) {
    Vector before = point;
    Vector after = point;
    before[j] = std::max(0.0, point[j] - difference);
    after[j] = std::min(1.0, point[j] + difference);
    const Vector slope = (residuals(after) - residuals(before)) / (after[j] - before[j]);
    if (j == 0) result.resize(slope.size(), point.size());
    result.col(j) = slope;
  }
  return result;
}

/// The parameters that a step may change: not the held one, and none that stands at an edge it is drawn across.
std::vector<Index> free_parameters(const Vector& point, const Vector& gradient, Index held) {
  std::vector<Index> free;
  for (Index j = 0; j < point.size(); ++j) {
    const bool at_edge = (point[j] <= 0.0 && gradient[j] > 0.0) || (point[j] >= 1.0 && gradient[j] < 0.0);
    if (j != held && !at_edge) free.push_back(j);
  }
  return free;
}

}  // namespace

LeastSquares descend(const Residuals& residuals, const Vector& start, Index held) {
  Vector z = residuals(start);
  LeastSquares at = {.point = start, .squares = z.squaredNorm()};
  double damping = 1e-3;
  for (int iteration = 0; iteration < max_iterations && at.squares > zero; ++iteration) {
    const Matrix slopes = jacobian(residuals, at.point);
    const Vector gradient = slopes.transpose() * z;
    const std::vector<Index> free = free_parameters(at.point, gradient, held);
    if (free.empty()) break;
    Matrix normal = (slopes.transpose() * slopes)(free, free);
    const Vector weight = normal.diagonal().array() + 1e-12 * normal.diagonal().maxCoeff() + 1e-300;
    double gain = 0.0;
    double length = 1.0;
    for (; length > least_step; damping *= 4.0) {
      Matrix damped = normal;
      damped.diagonal() += damping * weight;
      const Vector step = damped.ldlt().solve(-gradient(free));
      Vector next = at.point;
      next(free) += step;
      next = next.cwiseMax(0.0).cwiseMin(1.0);
      length = (next - at.point).cwiseAbs().maxCoeff();
      const Vector next_z = residuals(next);
      gain = at.squares - next_z.squaredNorm();
      if (!(gain > 0.0)) continue;
      at = {.point = next, .squares = next_z.squaredNorm()};
      z = next_z;
      damping = std::max(1e-12, damping / 16.0);
      break;
    }
    if (!(gain > no_gain * at.squares)) break;
  }
  return at;
}

}  // namespace repose
