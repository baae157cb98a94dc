#pragma once

#include <functional>

#include "calibration/linear_algebra.h"

namespace repose {

/// A smooth function: gives its value and sets its gradient.
using Objective = std::function<double(const Vector& x, Vector& gradient)>;

struct Minimum {
  Vector x;
  double value = 0.0;
};

/// A local minimum by the quasi-Newton method of Broyden, Fletcher, Goldfarb and Shanno (Nocedal and Wright, Numerical
/// Optimization, 2006, algorithm 6.1) with steps of at most 1 in each variable.
Minimum minimise(const Objective& objective, const Vector& start);

}  // namespace repose
