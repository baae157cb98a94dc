#include "scene/walls/wall_surface.h"

#include <cmath>
#include <numeric>
#include <utility>

#include "base/math.h"
#include "scene/walls/unit_vector.h"

namespace repose {
namespace {

constexpr std::size_t sides = 72;

void add_polygon(WallSurface& surface, std::vector<Vec3> corners) {
  if (corners.size() < 3) return;
  surface.polygons.emplace_back(corners.size());
  std::iota(surface.polygons.back().begin(), surface.polygons.back().end(), surface.points.size());
  surface.points.insert(surface.points.end(), corners.begin(), corners.end());
}

/// What of a polygon lies where sign times the coordinate is at most the bound (Sutherland and Hodgman 1974,
/// doi:10.1145/360767.360802).
std::vector<Vec3> cut(const std::vector<Vec3>& polygon, double Vec3::*coordinate, double sign, double bound) {
  std::vector<Vec3> kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec3& a = polygon[k];
    const Vec3& b = polygon[(k + 1) % polygon.size()];
    const double over_a = sign * a.*coordinate - bound;
    const double over_b = sign * b.*coordinate - bound;
    if (over_a <= 0.0) kept.push_back(a);
    if ((over_a <= 0.0) == (over_b <= 0.0)) continue;
    kept.push_back(a + (over_a / (over_a - over_b)) * (b - a));
    kept.back().*coordinate = sign * bound;  // without the rounding
  }
  return kept;
}

/// A square larger than the domain, cut by its six sides one after the other.
std::vector<Vec3> within(const DomainDeck& domain, const Vec3& point, const Vec3& normal) {
  const Vec3 middle = 0.5 * (domain.min + domain.max);
  const Vec3 centre = middle + dot(point - middle, normal) * normal;
  const double size = norm(domain.max - domain.min) + norm(centre - middle);
  const Vec3 other = std::fabs(normal.x) < 0.9 ? Vec3{1.0, 0.0, 0.0} : Vec3{0.0, 1.0, 0.0};
  const Vec3 u = size * unit_vector(cross(normal, other));
  const Vec3 v = cross(normal, u);
  std::vector<Vec3> polygon = {centre - u - v, centre + u - v, centre + u + v, centre - u + v};
  for (double Vec3::*coordinate : {&Vec3::x, &Vec3::y, &Vec3::z}) {
    polygon = cut(polygon, coordinate, 1.0, domain.max.*coordinate);
    polygon = cut(polygon, coordinate, -1.0, -domain.min.*coordinate);
  }
  return polygon;
}

void add(WallSurface& surface, const Plane& plane, const Placement& placement, const DomainDeck& domain) {
  add_polygon(surface, within(domain, placement.place(plane.point), placement.turn(plane.normal)));
}

void add(WallSurface& surface, const Rectangle& rectangle, const Placement& placement, const DomainDeck&) {
  const Vec3 u = rectangle.length_u * rectangle.u;
  const Vec3 v = rectangle.length_v * rectangle.v;
  const Vec3& c = rectangle.corner;
  add_polygon(surface,
              {placement.place(c), placement.place(c + u), placement.place(c + u + v), placement.place(c + v)});
}

/// A ring of points for each vertex, one point for a vertex on the axis; a quadrangle or triangle for each side of each
/// segment.
void add(WallSurface& surface, const Profile& profile, const Placement& placement, const DomainDeck&) {
  const Vec3 across = cross(profile.axis, profile.aside);
  std::vector<std::size_t> first;
  for (const auto& [r, z] : profile.vertices) {
    first.push_back(surface.points.size());
    for (std::size_t k = 0; k < (r > 0.0 ? sides : 1); ++k) {
      const SineCosine turn = sin_cos_reproducible(2.0 * pi * static_cast<double>(k) / double{sides});
      const Vec3 outward = turn.cosine * profile.aside + turn.sine * across;
      surface.points.push_back(placement.place(profile.origin + r * outward + z * profile.axis));
    }
  }
  const auto point = [&](std::size_t vertex, std::size_t k) {
    return first[vertex] + (profile.vertices[vertex][0] > 0.0 ? k % sides : 0);
  };
  for (std::size_t s = 0; s < profile.segments.size(); ++s) {
    const std::size_t next = (s + 1) % profile.vertices.size();
    for (std::size_t k = 0; k < sides; ++k) {
      std::vector<std::size_t> corners = {point(s, k)};
      for (const std::size_t p : {point(s, k + 1), point(next, k + 1), point(next, k)}) {
        if (p != corners.back() && p != corners.front()) corners.push_back(p);
      }
      surface.polygons.push_back(std::move(corners));
    }
  }
}

void add(WallSurface& surface, const Mesh& mesh, const Placement& placement, const DomainDeck&) {
  for (const Vec3& vertex : mesh.surface.vertices) surface.points.push_back(placement.place(vertex));
  for (const TriangleMesh::Triangle& t : mesh.surface.triangles) {
    surface.polygons.emplace_back(t.vertex.begin(), t.vertex.end());
  }
}

}  // namespace

WallSurface surface_of(const Wall& wall, const DomainDeck& domain) {
  WallSurface surface;
  std::visit([&](const auto& shape) { add(surface, shape, wall.placement, domain); }, wall.shape);
  return surface;
}

}  // namespace repose
