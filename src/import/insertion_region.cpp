#include "import/insertion_region.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "base/math.h"

namespace repose {
namespace {

constexpr std::array<double Vec3::*, 3> components = {&Vec3::x, &Vec3::y, &Vec3::z};
constexpr double rounding = 1e-9;  // of the size of a region, for what touches it

DeckRegion cylinder_of(const Vec3& centre, double radius, double height) {
  DeckRegion result{.is_box = false, .centre = centre, .radius = radius, .height = height};
  result.box.min = centre - Vec3{radius, radius, 0.0};
  result.box.max = centre + Vec3{radius, radius, height};
  return result;
}

/// The component of `way` that is the largest.
double Vec3::*main_component(const Vec3& way) {
  return *std::max_element(components.begin(), components.end(),
                           [&](double Vec3::*a, double Vec3::*b) { return std::fabs(way.*a) < std::fabs(way.*b); });
}

/// Whether a wall is a cylinder around a region that is one, about the same axis.
bool is_coaxial(const DeckRegion& region, const ScriptWall& wall) {
  const Vec3 across = wall.point - region.centre;
  return wall.shape == "zcylinder" && !region.is_box && wall.radius >= region.radius &&
         std::fabs(across.x) + std::fabs(across.y) <= rounding * region.radius;
}

}  // namespace

double DeckRegion::volume() const {
  const Vec3 size = box.max - box.min;
  return is_box ? size.x * size.y * size.z : pi * radius * radius * height;
}

double DeckRegion::length_along(const Vec3& way) const {
  const Vec3 size = box.max - box.min;
  const Vec3 n = (1.0 / norm(way)) * way;
  return std::fabs(n.x) * size.x + std::fabs(n.y) * size.y + std::fabs(n.z) * size.z;
}

double DeckRegion::smallest_size() const {
  const Vec3 size = box.max - box.min;
  return std::min({size.x, size.y, size.z});
}

DeckRegion deck_region(const ScriptRegion& region, const Extent& domain) {
  if (!region.is_inside) refuse(region.place, "grains come into the inside of a region; this is its outside");
  if (region.kind == "block") {
    DeckRegion result;
    const auto& [min, max] = region.block;
    result.box = {{std::max(min.x, domain.min.x), std::max(min.y, domain.min.y), std::max(min.z, domain.min.z)},
                  {std::min(max.x, domain.max.x), std::min(max.y, domain.max.y), std::min(max.z, domain.max.z)}};
    return result;
  }
  if (region.kind != "cylinder")
    refuse(region.place, fmt::format("grains in a {}: block and cylinder are known", region.kind));
  if (region.axis != 'z')
    refuse(region.place, "grains in a cylinder that is not upright; only one along z has a counterpart");
  const double low = std::max(region.low, domain.min.z);
  return cylinder_of({region.c1, region.c2, low}, region.radius, std::min(region.high, domain.max.z) - low);
}

bool are_same(const DeckRegion& a, const DeckRegion& b) {
  return a.is_box == b.is_box && a.box.min == b.box.min && a.box.max == b.box.max;
}

bool overlap(const DeckRegion& a, const DeckRegion& b) {
  return std::all_of(components.begin(), components.end(),
                     [&](double Vec3::*c) { return a.box.min.*c < b.box.max.*c && b.box.min.*c < a.box.max.*c; });
}

bool is_held(const DeckRegion& region, const Vec3& way, double gap, const ScriptWall& wall) {
  if (wall.shape.empty()) return false;
  double Vec3::*along = main_component(way);
  const bool is_across = std::fabs(wall.direction.*along) > 0.5;
  if (is_across != wall.shape.ends_with("plane")) return false;
  const double sign = way.*along > 0.0 ? 1.0 : -1.0;
  const double at = sign * (wall.point.*along + sign * wall.radius);  // along the way, as are the ends of the region
  const double begin = sign * (sign > 0.0 ? region.box.min : region.box.max).*along;
  const double end = sign * (sign > 0.0 ? region.box.max : region.box.min).*along;
  return at > begin && at <= end + gap;
}

bool can_bound(const DeckRegion& region, const ScriptWall& wall) {
  return wall.shape.ends_with("plane") || is_coaxial(region, wall);
}

DeckRegion grown(const DeckRegion& region, double by, const Extent& domain,
                 const std::vector<const ScriptWall*>& walls) {
  Extent box = region.box;
  double radius_by = by;
  for (double Vec3::*c : components) {
    const double touch = rounding * (region.box.max.*c - region.box.min.*c);
    double low = std::max(domain.min.*c, region.box.min.*c - by);
    double high = std::min(domain.max.*c, region.box.max.*c + by);
    for (const ScriptWall* wall : walls) {
      if (!wall->shape.ends_with("plane") || !(wall->direction.*c > 0.5)) continue;
      const double at = wall->point.*c;
      if (at <= region.box.min.*c + touch) low = std::max(low, at);
      if (at >= region.box.max.*c - touch) high = std::min(high, at);
    }
    box.min.*c = std::min(low, region.box.min.*c);
    box.max.*c = std::max(high, region.box.max.*c);
    if (c != &Vec3::z)
      radius_by = std::min({radius_by, region.box.min.*c - box.min.*c, box.max.*c - region.box.max.*c});
  }
  if (!region.is_box) {
    for (const ScriptWall* wall : walls) {
      if (is_coaxial(region, *wall)) radius_by = std::min(radius_by, wall->radius - region.radius);
    }
    const Vec3 centre = {region.centre.x, region.centre.y, box.min.z};
    return cylinder_of(centre, region.radius + std::max(0.0, radius_by), box.max.z - box.min.z);
  }
  DeckRegion result;
  result.box = box;
  return result;
}

}  // namespace repose
