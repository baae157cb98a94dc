#include "measurement/surface_angle.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "base/math.h"
#include "measurement/bed.h"
#include "scene/walls/unit_vector.h"

namespace repose {
namespace {

/// The slope from columns of this width, of grains whose centres are within `half` of the axis; both in m.
std::optional<double> slope_of(const SurfaceAngleDeck& deck, const Vec3& gravity, std::span<const Sphere> bed,
                               double width, double half) {
  constexpr std::size_t least_columns = 4;
  const Vec3 axis = unit_vector(deck.axis_direction);
  const Vec3 against_gravity = dot(gravity, axis) * axis - gravity;
  if (!(norm(against_gravity) > 0.0)) return {};
  const Vec3 up = unit_vector(against_gravity);
  const Vec3 across = cross(axis, up);
  std::map<int, Vec3> highest;  // by column: across, height
  for (const Sphere& grain : bed) {
    const Vec3 from_axis = grain.centre - deck.axis_origin;
    const double x = dot(from_axis, across);
    if (std::fabs(x) > half) continue;
    const Vec3 top = {x, dot(from_axis, up) + grain.radius, 0.0};
    const auto [column, is_new] = highest.try_emplace(static_cast<int>(std::floor(x / width)), top);
    if (!is_new && top.y > column->second.y) column->second = top;
  }
  if (highest.size() < least_columns) return {};
  StraightLine line;
  for (const auto& [column, p] : highest) line.add(p.x, p.y);
  return atan_reproducible(line.slope());  // phases end by it
}

}  // namespace

std::optional<double> surface_angle(const SurfaceAngleDeck& deck, const Vec3& gravity, std::span<const Sphere> grains) {
  if (grains.empty()) return {};
  const std::vector<Sphere> bed = largest_cluster(grains);
  return slope_of(deck, gravity, bed, 2.0 * mean_diameter(bed), deck.half_width * deck.radius);
}

std::optional<double> surface_angle_at_rest(const SurfaceAngleDeck& deck, const Vec3& gravity,
                                            std::span<const Sphere> bed) {
  if (bed.empty()) return {};
  const double width = 2.0 * mean_diameter(bed);
  return slope_of(deck, gravity, bed, width, width * std::floor(deck.half_width * deck.radius / width));
}

}  // namespace repose
