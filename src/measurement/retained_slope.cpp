#include "measurement/retained_slope.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "measurement/bed.h"

namespace repose {
namespace {

constexpr double ring_width = 1.0;   // of the mean diameter
constexpr double cell_length = 2.0;  // of the mean diameter, along the ring
constexpr std::size_t least_rings = 3;

struct Ring {
  double radius = 0.0;  ///< middle, m
  double height = 0.0;  ///< above the floor: mean over its cells of the highest point, m
};

/// The rings from the axis to the wall, by cells along them. Cells without grains have no height.
std::vector<Ring> rings_of(const RetainedSlopeDeck& deck, std::span<const Sphere> bed, double width) {
  const auto count = static_cast<int>(std::floor(deck.radius / width));
  std::map<std::pair<int, int>, double> highest;  // by ring and cell
  const auto cells = [](int ring) {
    return std::max(1, static_cast<int>(2.0 * pi * (ring + 0.5) * ring_width / cell_length));
  };
  for (const Sphere& grain : bed) {
    const double x = grain.centre.x - deck.axis.x, y = grain.centre.y - deck.axis.y;
    const int ring = static_cast<int>(std::floor(std::hypot(x, y) / width));
    if (ring >= count) continue;
    const double turn = std::atan2(y, x) / (2.0 * pi) + 0.5;
    const int cell = std::min(cells(ring) - 1, static_cast<int>(turn * cells(ring)));
    double& top = highest.try_emplace({ring, cell}, 0.0).first->second;
    top = std::max(top, grain.centre.z + grain.radius - deck.orifice_height);
  }
  std::map<int, std::pair<double, int>> sums;
  for (const auto& [place, top] : highest) {
    sums[place.first].first += top;
    ++sums[place.first].second;
  }
  std::vector<Ring> rings;
  for (const auto& [ring, sum] : sums) rings.push_back({(ring + 0.5) * width, sum.first / sum.second});
  return rings;
}

}  // namespace

std::optional<double> retained_slope(const RetainedSlopeDeck& deck, std::span<const Sphere> grains) {
  std::vector<Sphere> above;
  std::copy_if(grains.begin(), grains.end(), std::back_inserter(above),
               [&](const Sphere& grain) { return grain.centre.z > deck.orifice_height; });
  const std::vector<Sphere> bed = largest_cluster(above);
  if (bed.empty()) return {};
  const std::vector<Ring> rings = rings_of(deck, bed, ring_width * mean_diameter(bed));
  double wall = 0.0;
  for (const Ring& ring : rings) wall = std::max(wall, ring.height);
  StraightLine line;
  for (const Ring& ring : rings) {
    if (ring.height >= deck.fit_from * wall && ring.height <= deck.fit_to * wall) line.add(ring.radius, ring.height);
  }
  if (line.count() < least_rings) return {};
  return std::atan(line.slope());
}

}  // namespace repose
