#include "thermal/plane_source/laplace_inversion.h"

#include "base/math.h"

namespace repose::thermal {

LaplaceContour::LaplaceContour(double end) {
  constexpr int count = 24;
  constexpr double angle =
      1.0969072690726909;  // makes the rate of convergence greatest for this span: exp(-1.357 count)
  const double width =
      std::acosh(((pi - 2.0 * angle) * span + 4.0 * angle - pi) / ((4.0 * angle - pi) * std::sin(angle)));
  const double step = width / count;
  const double scale = (4.0 * pi * angle - pi * pi) / width * count / end;
  for (int i = 0; i < count; ++i) {
    const std::complex<double> u(-angle, (i + 0.5) * step);
    points_.push_back(scale * (1.0 + std::sin(u)));
    weights_.push_back(std::complex<double>(0.0, scale * step / pi) * std::cos(u));
  }
}

}  // namespace repose::thermal
