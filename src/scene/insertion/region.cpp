#include "scene/insertion/region.h"

#include <array>
#include <cmath>

#include "base/math.h"

namespace repose {
namespace {

double top_radius(const ParticlesDeck& frustum) {
  return std::isnan(frustum.radius_top) ? frustum.radius : frustum.radius_top;
}

Vec3 unit(const Vec3& v) { return (1.0 / norm(v)) * v; }

/// Two unit vectors perpendicular to one another and to a unit vector.
std::array<Vec3, 2> across(const Vec3& normal) {
  const Vec3 other = std::fabs(normal.z) < 0.75 ? Vec3{0.0, 0.0, 1.0} : Vec3{1.0, 0.0, 0.0};
  const Vec3 first = unit(cross(other, normal));
  return {first, cross(normal, first)};
}

}  // namespace

Box bounds(const ParticlesDeck& region) {
  if (region.region == RegionShape::box) return {region.min, region.max};
  if (region.region == RegionShape::disc) {
    const Vec3 n = unit(region.normal);
    const auto half = [&](double c) { return region.radius * std::sqrt(std::fmax(0.0, 1.0 - c * c)); };
    const Vec3 size = {half(n.x), half(n.y), half(n.z)};
    return {region.centre - size, region.centre + size};
  }
  const double widest = std::fmax(region.radius, top_radius(region));
  return {region.centre - Vec3{widest, widest, 0.0}, region.centre + Vec3{widest, widest, region.height}};
}

double region_size(const ParticlesDeck& region) {
  const double r = region.radius;
  if (region.region == RegionShape::disc) return pi * r * r;
  if (region.region == RegionShape::box) {
    const Vec3 size = region.max - region.min;
    return size.x * size.y * size.z;
  }
  const double top = top_radius(region);
  return pi / 3.0 * region.height * (r * r + r * top + top * top);
}

bool inside_side(const ParticlesDeck& frustum, const Vec3& centre, double radius, double shift, double tolerance) {
  const double slope = (top_radius(frustum) - frustum.radius) / frustum.height;
  const double x = std::fabs(centre.x - frustum.centre.x) + shift;
  const double y = std::fabs(centre.y - frustum.centre.y) + shift;
  const double narrowest = frustum.radius + slope * (centre.z - frustum.centre.z) - std::fabs(slope) * shift;
  const double reach = radius * std::sqrt(1.0 + slope * slope);  // of the sphere across the cone's side
  return std::sqrt(x * x + y * y) + reach <= narrowest + tolerance;
}

bool holds_sphere(const ParticlesDeck& region, const Vec3& centre, double radius) {
  const auto [min, max] = bounds(region);
  const double room = radius * (1.0 - fit_rounding);
  const auto fits = [&](double x, double low, double high) { return x - low >= room && high - x >= room; };
  if (!fits(centre.z, min.z, max.z)) return false;
  if (region.region == RegionShape::cylinder) return inside_side(region, centre, radius, 0.0, fit_rounding * radius);
  return fits(centre.x, min.x, max.x) && fits(centre.y, min.y, max.y);
}

std::optional<Vec3> random_place(const ParticlesDeck& region, double radius, std::uint64_t seed, std::int64_t id,
                                 RandomStream stream, std::uint32_t k) {
  const auto share = [&](std::uint32_t axis) {
    return uniform(seed, static_cast<std::uint64_t>(id), stream, k + axis);
  };
  if (region.region == RegionShape::disc) {
    const double free = region.radius - radius;
    const double u = 2.0 * share(0) - 1.0;
    const double v = 2.0 * share(1) - 1.0;
    if (free < 0.0 || u * u + v * v > 1.0) return {};
    const auto [first, second] = across(unit(region.normal));
    return region.centre + (free * u) * first + (free * v) * second;
  }
  const auto [min, max] = bounds(region);
  const Vec3 low = min + Vec3{radius, radius, radius};
  const Vec3 size = max - min - 2.0 * Vec3{radius, radius, radius};
  const Vec3 place = low + Vec3{share(0) * size.x, share(1) * size.y, share(2) * size.z};
  if (!holds_sphere(region, place, radius)) return {};
  return place;
}

bool clear_of_walls(const Vec3& centre, double radius, const std::vector<Wall>& walls) {
  for (const Wall& wall : walls) {
    if (wall.present && distance(wall, centre) < radius * (1.0 - fit_rounding)) return false;
  }
  return true;
}

}  // namespace repose
