#include "scene/particles/periodicity.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/core.h>

#include "base/error.h"
#include "deck/deck.h"
#include "scene/particles/particles.h"

namespace repose {
namespace {

/// The power of two of which all doubles up to two lengths beyond the bounds are at least half.
double grid_spacing(double min, double max) {
  int exponent = 0;
  std::frexp(std::max(std::fabs(min), std::fabs(max)) + 2.0 * (max - min), &exponent);
  return std::ldexp(1.0, exponent - std::numeric_limits<double>::digits);
}

}  // namespace

bool is_outside(const DomainDeck& domain, const Vec3& x) {
  const Vec3 low = domain.min;
  const Vec3 high = domain.max;
  return x.x < low.x || x.x >= high.x || x.y < low.y || x.y >= high.y || x.z < low.z || x.z >= high.z;
}

Periodicity::Periodicity(const DomainDeck& domain) : any_(!domain.periodic.empty()) {
  for (const Axis axis : domain.periodic) {
    double Vec3::*a = component(axis);
    const double spacing = grid_spacing(domain.min.*a, domain.max.*a);
    spacing_.*a = spacing;
    low_.*a = std::floor(domain.min.*a / spacing) * spacing;
    high_.*a = -std::floor(-domain.max.*a / spacing) * spacing;
    length_.*a = high_.*a - low_.*a;
    rounding_.*a = std::ldexp(1.5 * spacing, 52);
  }
}

DomainDeck Periodicity::open_bounds(const DomainDeck& domain) const {
  DomainDeck open = domain;
  for (const Axis axis : domain.periodic) {
    open.min.*component(axis) = -infinite;
    open.max.*component(axis) = parking_distance;
  }
  return open;
}

Vec3 Periodicity::on_grid(const Vec3& x) const {
  if (!any_) return x;
  const auto round = [](double value, double spacing) {
    return spacing > 0.0 ? std::floor(value / spacing + 0.5) * spacing : value + 0.0;  // a negative zero would not keep
  };
  return wrapped({round(x.x, spacing_.x), round(x.y, spacing_.y), round(x.z, spacing_.z)});
}

double Periodicity::longest_range() const {
  double shortest = infinite;
  for (const double length : {length_.x, length_.y, length_.z}) {
    if (length > 0.0) shortest = std::min(shortest, length);
  }
  return 0.5 * shortest;
}

SpheresWithImages with_images(const Periodicity& periodic, std::span<const Vec3> position,
                              std::span<const double> radius) {
  SpheresWithImages all = {{position.begin(), position.end()}, {radius.begin(), radius.end()}, {}};
  for (std::size_t i = 0; i < position.size(); ++i) all.original.push_back(i);
  if (!periodic.any() || radius.empty()) return all;
  const double largest = *std::max_element(radius.begin(), radius.end());
  for (std::size_t i = 0; i < position.size(); ++i) {
    periodic.for_each_shift(position[i], radius[i] + largest, [&](const Vec3& shift) {
      if (shift == Vec3{}) return;
      all.position.push_back(position[i] + shift);
      all.radius.push_back(radius[i]);
      all.original.push_back(i);
    });
  }
  return all;
}

double longest_skin(const Periodicity& periodic, double reach, std::string_view further) {
  const double longest_reach = 0.5 * periodic.longest_range();
  if (longest_reach < 1.25 * reach) {
    const std::string times =
        further.empty() ? fmt::format("2.5 times the largest diameter {:.4g} m", 2.0 * reach)
                        : fmt::format("5 times the largest reach {:.4g} m of a particle (with {})", reach, further);
    throw DeckError(fmt::format(
        "domain.periodic: the domain is {:.4g} m long, less than {}, so that a particle would meet its own image; "
        "enlarge it to {:.4g} m",
        4.0 * longest_reach, times, 5.0 * reach));
  }
  return longest_reach - reach;
}

}  // namespace repose
