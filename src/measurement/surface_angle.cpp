#include "measurement/surface_angle.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "measurement/clusters.h"
#include "scene/walls/unit_vector.h"

namespace repose {
namespace {

/// The grains of the largest cluster of touching ones.
std::vector<Sphere> without_flying(std::span<const Sphere> grains) {
  constexpr double gap = 0.05;  // of the smaller diameter: a flowing bed is looser than one at rest
  const std::vector<std::size_t> cluster = touching_clusters(grains, gap);
  std::vector<std::size_t> size(grains.size(), 0);
  for (const std::size_t c : cluster) ++size[c];
  const auto largest = static_cast<std::size_t>(std::max_element(size.begin(), size.end()) - size.begin());
  std::vector<Sphere> bed;
  for (std::size_t i = 0; i < grains.size(); ++i) {
    if (cluster[i] == largest) bed.push_back(grains[i]);
  }
  return bed;
}

/// Slope of the straight line nearest to the points (least squares).
double slope_of(const std::map<int, Vec3>& points) {
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (const auto& [column, p] : points) {
    n += 1.0;
    x += p.x;
    y += p.y;
    xx += p.x * p.x;
    xy += p.x * p.y;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

}  // namespace

std::optional<double> surface_angle(const SurfaceAngleDeck& deck, const Vec3& gravity, std::span<const Sphere> grains) {
  constexpr std::size_t least_columns = 4;
  if (grains.empty()) return {};
  const Vec3 axis = unit_vector(deck.axis_direction);
  const Vec3 against_gravity = dot(gravity, axis) * axis - gravity;
  if (!(norm(against_gravity) > 0.0)) return {};
  const Vec3 up = unit_vector(against_gravity);
  const Vec3 across = cross(axis, up);
  const std::vector<Sphere> bed = without_flying(grains);
  double mean_radius = 0.0;
  for (const Sphere& grain : bed) mean_radius += grain.radius / static_cast<double>(bed.size());
  const double width = 4.0 * mean_radius;
  std::map<int, Vec3> highest;  // by column: across, height
  for (const Sphere& grain : bed) {
    const Vec3 from_axis = grain.centre - deck.axis_origin;
    const double x = dot(from_axis, across);
    if (std::fabs(x) > deck.half_width * deck.radius) continue;
    const Vec3 top = {x, dot(from_axis, up) + grain.radius, 0.0};
    const auto [column, is_new] = highest.try_emplace(static_cast<int>(std::floor(x / width)), top);
    if (!is_new && top.y > column->second.y) column->second = top;
  }
  if (highest.size() < least_columns) return {};
  return std::atan(slope_of(highest));
}

}  // namespace repose
