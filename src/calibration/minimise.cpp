#include "calibration/minimise.h"

#include <algorithm>
#include <cmath>

namespace repose {
namespace {

constexpr int max_iterations = 80;
constexpr double flat = 1e-4;         // greatest element of a gradient that counts as none
constexpr double no_gain = 1e-8;      // of a step that is not worth another one
constexpr double least_share = 1e-8;  // of a step, in the line search

/// The descent direction, not longer than 1 in any variable.
Vector step_along(const Matrix& inverse_hessian, const Vector& gradient) {
  Vector step = -(inverse_hessian * gradient);
  if (step.dot(gradient) >= 0.0) step = -gradient;
  return step / std::max(1.0, step.cwiseAbs().maxCoeff());
}

/// The update of the inverse Hessian by one step and the change of the gradient over it.
void update(Matrix& inverse, const Vector& step, const Vector& change, bool first) {
  const double curvature = step.dot(change);
  // Without positive curvature along the step the matrix would lose its definiteness.
  if (!(curvature > 1e-12 * step.norm() * change.norm())) return;
  if (first) inverse = Matrix::Identity(step.size(), step.size()) * (curvature / change.squaredNorm());
  const Vector moved = inverse * change;
  const double factor = (1.0 + change.dot(moved) / curvature) / curvature;
  inverse += factor * step * step.transpose() - (moved * step.transpose() + step * moved.transpose()) / curvature;
}

}  // namespace

Minimum minimise(const Objective& objective, const Vector& start) {
  Minimum at = {.x = start, .value = 0.0};
  Vector gradient(start.size());
  at.value = objective(at.x, gradient);
  Matrix inverse = Matrix::Identity(start.size(), start.size());
  bool first = true;
  for (int iteration = 0; iteration < max_iterations && gradient.cwiseAbs().maxCoeff() > flat; ++iteration) {
    const Vector step = step_along(inverse, gradient);
    Vector next_gradient(start.size());
    double share = 1.0;
    double value = 0.0;
    for (; share > least_share; share *= 0.5) {
      value = objective(at.x + share * step, next_gradient);
      if (value <= at.value + 1e-4 * share * step.dot(gradient)) break;
    }
    if (!(share > least_share)) break;
    const double gain = at.value - value;
    update(inverse, share * step, next_gradient - gradient, first);
    first = false;
    at = {.x = at.x + share * step, .value = value};
    gradient = next_gradient;
    if (gain < no_gain) break;
  }
  return at;
}

}  // namespace repose
