#include "measurement/scattering.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/core.h>

#include "base/error.h"
#include "measurement/pile.h"

namespace repose {
namespace {

constexpr double everywhere = std::numeric_limits<double>::infinity();

double distance_from_axis(const ScatteringDeck& deck, const Sphere& grain) {
  return std::hypot(grain.centre.x - deck.axis.x, grain.centre.y - deck.axis.y);
}

bool is_over_plate(const ScatteringDeck& deck, const Sphere& grain) {
  const Vec3& p = grain.centre;
  return p.x >= deck.plate_min.x && p.x <= deck.plate_max.x && p.y >= deck.plate_min.y && p.y <= deck.plate_max.y &&
         p.z >= deck.plate_height;
}

bool lies_on_plate(const ScatteringDeck& deck, const Sphere& grain) {
  return grain.centre.z - grain.radius - deck.plate_height <= 2.0 * deck.on_plate_gap * grain.radius;
}

double median_diameter(std::span<const Sphere> grains) {
  std::vector<double> diameters;
  for (const Sphere& grain : grains) diameters.push_back(2.0 * grain.radius);
  const auto middle = diameters.begin() + static_cast<std::ptrdiff_t>(diameters.size() / 2);
  std::nth_element(diameters.begin(), middle, diameters.end());
  return *middle;
}

struct Ring {
  double grains = 0.0;
  double density = 0.0;  ///< grains per area
};

/// Rings of the given width about the axis; behind the last one with grains comes an empty one.
std::vector<Ring> count_in_rings(std::span<const double> distances, double width) {
  std::vector<Ring> rings;
  for (const double r : distances) {
    const auto k = static_cast<std::size_t>(r / width);
    if (rings.size() < k + 2) rings.resize(k + 2);
    rings[k].grains += 1.0;
  }
  for (std::size_t k = 0; k < rings.size(); ++k) {
    rings[k].density = rings[k].grains / (pi * width * width * (2.0 * static_cast<double>(k) + 1.0));
  }
  return rings;
}

/// The density that the densest rings with a quarter of all grains have at least. Not that about the axis: the first
/// grains that fall blow a crater into the layer that they make.
double density_under_pile(std::vector<Ring> rings, std::size_t grains) {
  std::sort(rings.begin(), rings.end(), [](const Ring& a, const Ring& b) { return a.density > b.density; });
  double sum = 0.0;
  const auto enough = std::find_if(rings.begin(), rings.end(), [&](const Ring& ring) {
    sum += ring.grains;
    return sum >= 0.25 * static_cast<double>(grains);
  });
  return enough->density;
}

AreaCount count_between(std::span<const double> distances, double from, double to) {
  AreaCount area{.from = from, .to = {}};
  if (to < everywhere) area.to = to;
  area.count = std::count_if(distances.begin(), distances.end(), [&](double r) { return r >= from && r < to; });
  area.error = std::sqrt(std::max(1.0, static_cast<double>(area.count)));
  return area;
}

}  // namespace

std::optional<double> end_of_dense_part(std::span<const double> densities, double ring_width, double least) {
  for (std::size_t last = densities.size(); last-- > 0;) {
    if (densities[last] < least) continue;
    const double next = last + 1 < densities.size() ? densities[last + 1] : 0.0;
    const double beyond = (densities[last] - least) / (densities[last] - next);
    return ring_width * (static_cast<double>(last) + 0.5 + beyond);
  }
  return {};
}

std::optional<double> base_radius(const ScatteringDeck& deck, std::span<const Sphere> grains) {
  const std::vector<Sphere> pile = find_pile(grains, deck.plate_height, deck.max_height);
  if (pile.empty()) return std::nullopt;
  std::vector<double> distances;
  for (const Sphere& grain : grains) {
    if (is_over_plate(deck, grain) && lies_on_plate(deck, grain)) distances.push_back(distance_from_axis(deck, grain));
  }
  if (distances.empty()) return std::nullopt;  // the pile lies beside the plate
  const double width = std::isnan(deck.ring_width) ? 2.0 * median_diameter(pile) : deck.ring_width;
  const std::vector<Ring> rings = count_in_rings(distances, width);
  std::vector<double> densities;
  for (const Ring& ring : rings) densities.push_back(ring.density);
  return end_of_dense_part(densities, width, deck.base_share * density_under_pile(rings, distances.size()));
}

std::optional<Scattering> scattering(const ScatteringDeck& deck, std::span<const Sphere> grains,
                                     std::int64_t left_domain) {
  Scattering result;
  result.off_plate = left_domain;
  result.measured_base_radius = base_radius(deck, grains);
  if (!result.measured_base_radius && std::isnan(deck.base_radius)) return std::nullopt;
  result.base_radius = std::isnan(deck.base_radius) ? *result.measured_base_radius : deck.base_radius;
  if (result.base_radius >= deck.area_3_radius) {
    throw DeckError(
        fmt::format("measurement.scattering.area_3_radius = {:.4g} m lies within the base of the pile, whose radius is "
                    "{:.4g} m; choose a greater one",
                    deck.area_3_radius, result.base_radius));
  }
  std::vector<double> distances;
  for (const Sphere& grain : grains) {
    if (grain.centre.z > deck.max_height) continue;
    if (is_over_plate(deck, grain)) {
      distances.push_back(distance_from_axis(deck, grain));
    } else {
      ++result.off_plate;
    }
  }
  const auto area_1 = [&](double width) {
    return count_between(distances, result.base_radius, result.base_radius + width);
  };
  const auto area_3 = [&](double radius) { return count_between(distances, radius, everywhere); };
  result.area_1 = area_1(deck.area_1_width);
  result.area_3 = area_3(deck.area_3_radius);
  if (*result.area_1.to <= deck.area_3_radius) {
    result.area_2 = count_between(distances, *result.area_1.to, deck.area_3_radius);
  }
  for (const double width : deck.area_1_widened) result.area_1_widened.push_back(area_1(width));
  for (const double radius : deck.area_3_widened) {
    result.area_3_widened.push_back(area_3(std::max(radius, result.base_radius)));
  }
  return result;
}

}  // namespace repose
