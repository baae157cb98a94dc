#include "scene/particles/damping.h"

#include <cmath>

#include "base/math.h"

namespace repose {
namespace {

/// t / sin t where `x` = cos t, or t / sinh t where x = cosh t: by t / sin t = 1 / (cos(t/2) cos(t/4) ...), Viete's
/// product, both are one function, of square roots alone.
double angle_over_sine(double x) {
  double ratio = 1.0;
  for (int halving = 0; halving < 60 && x != 1.0; ++halving) {
    x = std::sqrt(0.5 * (1.0 + x));  // cosine of half the angle
    ratio /= x;
  }
  return ratio;
}

/// -ln e of a collision that ends when the force is zero.
double logarithmic_loss(double zeta) { return 2.0 * zeta * angle_over_sine(zeta); }

}  // namespace

double damping_ratio(double restitution) {
  if (restitution <= 0.0) return -1.0;
  const double log_e = log_reproducible(restitution);
  return log_e / std::sqrt(log_e * log_e + pi * pi);
}

double damping_ratio_without_attraction(double restitution) {
  const double loss = -log_reproducible(restitution);
  if (!(loss > 0.0)) return 0.0;
  double low = 0.0;
  double high = 1.0;
  while (logarithmic_loss(high) < loss) high *= 2.0;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (low + high);
    (logarithmic_loss(middle) < loss ? low : high) = middle;
  }
  return -high;
}

}  // namespace repose
