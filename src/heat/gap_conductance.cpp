#include "heat/gap_conductance.h"

#include <algorithm>
#include <cmath>

#include "base/math.h"
#include "base/root.h"
#include "heat/constants.h"
#include "heat/gauss.h"

namespace repose {
namespace {

/// One grain of the pair in the double cone: from the apex at its centre to the middle of the gap.
struct Side {
  double radius;
  double height;  ///< of the cone, R + H
  double base;    ///< radius of its base, r_ij
  double conductivity;

  /// Where the cone's surface meets the grain's.
  double rim() const { return radius * base / std::sqrt(base * base + height * height); }
  double surface(double r) const { return std::sqrt(std::max(0.0, radius * radius - r * r)); }
  /// Length of a column inside the grain and inside the cone, over the conductivity.
  double resistance(double r) const { return std::max(0.0, surface(r) - r * height / base) / conductivity; }
  double to_middle(double r) const { return height - surface(r); }
};

}  // namespace

double contact_radius(double radius_1, double radius_2, double overlap, double stiffness_ratio) {
  return contact_radius_by_root(radius_1, radius_2, overlap, odd_root<3>(stiffness_ratio));
}

double contact_radius_by_root(double radius_1, double radius_2, double overlap, double stiffness_root) {
  if (overlap <= 0.0) return 0.0;
  const double r_eff = radius_1 * radius_2 / (radius_1 + radius_2);
  return std::sqrt(r_eff * overlap) * stiffness_root;  // (T.15)
}

double contact_conductance(const GrainPair& pair) {
  return 4.0 * pair.contact_radius / (1.0 / pair.conductivity_1 + 1.0 / pair.conductivity_2);  // (T.16)
}

double gap_conductance(const GrainPair& pair, const GapFill& fill, double porosity) {
  const double half_gap = 0.5 * std::max(0.0, pair.gap);
  const double mean_radius = 0.5 * (pair.radius_1 + pair.radius_2);
  const double base = 0.560 * mean_radius / odd_root<3>(1.0 - porosity);
  const Side first{pair.radius_1, pair.radius_1 + half_gap, base, pair.conductivity_1};
  const Side second{pair.radius_2, pair.radius_2 + half_gap, base, pair.conductivity_2};
  const auto per_radius = [&](double r) {
    const double gap = first.to_middle(r) + second.to_middle(r) + fill.free_path;
    const double fluid = gap > 0.0 ? 1.0 / (fill.conductivity / gap + fill.radiation) : 0.0;
    return 2.0 * pi * r / (first.resistance(r) + second.resistance(r) + fluid);  // (T.17)
  };
  // Towards the axis the gap closes as r^2: panels that halve, and a last one to the axis or the contact.
  const double inner = pair.contact_radius;
  double outer = std::min(first.rim(), second.rim());
  double sum = 0.0;
  constexpr int panels = 14;
  for (int i = 0; i < panels && outer > inner; ++i) {
    const double next = i + 1 < panels ? std::max(inner, 0.5 * outer) : inner;
    sum += gauss_integral(next, outer, per_radius);
    outer = next;
  }
  return sum;
}

double radiative_coefficient(double temperature, double emissivity_1, double emissivity_2) {
  const double cube = temperature * temperature * temperature;
  return 4.0 * stefan_boltzmann * cube / (1.0 / emissivity_1 + 1.0 / emissivity_2 - 1.0);  // (T.18)
}

}  // namespace repose
