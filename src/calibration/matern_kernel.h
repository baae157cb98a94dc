#pragma once

#include <cmath>

#include "calibration/linear_algebra.h"

namespace repose {

/// The Matern kernel of order 5/2 (Rasmussen and Williams 2006, eq. 4.17) with a length scale for each parameter.
/// Its functions have two derivatives. The squared exponential has all: it takes what it sees at the points for
/// certain between them, and its intervals are too short where a response bends, as at the edge of plugging.
struct MaternKernel {
  Vector lengths;  ///< in units of the box

  /// Correlation of two points at the scaled distance r (C.1).
  static double correlation(double r) {
    const double a = std::sqrt(5.0) * r;
    return (1.0 + a + a * a / 3.0) * std::exp(-a);
  }
  /// -(dk/dr) / r, finite at r = 0: dk/dx_j = -slope (x_j - y_j) / l_j^2, dk/d(ln l_j) = slope (x_j - y_j)^2 / l_j^2.
  static double slope(double r) {
    const double a = std::sqrt(5.0) * r;
    return 5.0 / 3.0 * (1.0 + a) * std::exp(-a);
  }

  /// Correlations of the rows of `a` (down) with those of `b` (across).
  Matrix between(const Matrix& a, const Matrix& b) const {
    const Matrix distance = scaled_distances(a, b);
    return distance.unaryExpr([](double r) { return correlation(r); });
  }
  Matrix slopes(const Matrix& a, const Matrix& b) const {
    return scaled_distances(a, b).unaryExpr([](double r) { return slope(r); });
  }

 private:
  Matrix scaled_distances(const Matrix& a, const Matrix& b) const {
    Matrix squares = Matrix::Zero(a.rows(), b.rows());
    for (Index k = 0; k < a.cols(); ++k) {
      for (Index j = 0; j < b.rows(); ++j) {
        squares.col(j).array() += ((a.col(k).array() - b(j, k)) / lengths[k]).square();
      }
    }
    return squares.cwiseSqrt();
  }
};

}  // namespace repose
