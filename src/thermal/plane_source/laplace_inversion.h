#pragma once

#include <cmath>
#include <complex>
#include <vector>

namespace repose::thermal {

/// The numerical inversion of Laplace transforms whose singularities lie on the real axis at s <= 0: the trapezium rule
/// on a hyperbola about that axis, one for all times in [end/span, end] (Weideman and Trefethen,
/// doi:10.1090/S0025-5718-07-01945-X, section 4). The error is about 1e-11 of the function's size in these times.
class LaplaceContour {
 public:
  static constexpr double span = 4.0;

  /// `end` in s, > 0.
  explicit LaplaceContour(double end);

  /// Where the transform has to be known, in 1/s. Half of the contour: functions are real.
  const std::vector<std::complex<double>>& points() const { return points_; }

  /// The function at `time` from its transform at the points, in their order.
  double invert(const std::vector<std::complex<double>>& transform, double time) const {
    std::complex<double> sum = 0.0;
    for (std::size_t i = 0; i < points_.size(); ++i) sum += weights_[i] * transform[i] * std::exp(points_[i] * time);
    return sum.imag();
  }

 private:
  std::vector<std::complex<double>> points_;
  std::vector<std::complex<double>> weights_;  ///< ds/du times the step over pi
};

}  // namespace repose::thermal
