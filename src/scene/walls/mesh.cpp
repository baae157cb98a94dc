#include "scene/walls/mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory_resource>
#include <stdexcept>
#include <tuple>

#include <fmt/core.h>

#include "base/math.h"
#include "scene/walls/motion.h"
#include "scene/walls/stl.h"
#include "scene/walls/unit_vector.h"

namespace repose {

namespace {

/// Exact for multiples of a right angle.
SineCosine sin_cos_of_degrees(double angle) {
  const double quarters = std::floor(angle / 90.0 + 0.5);
  return turned_by_quarters(sin_cos_reproducible((angle - 90.0 * quarters) * degree), quarters);
}

void place(const MeshPlacement& placement, TriangleMesh& mesh) {
  const Vec3 axis = unit_vector(placement.rotate_axis);
  const SineCosine angle = sin_cos_of_degrees(placement.rotate_angle);
  for (Vec3& v : mesh.vertices) v = placement.translate + turned(placement.scale * v, axis, angle);
  mesh.tolerance *= placement.scale;
}

BoundingBox bounds_of(const TriangleMesh& mesh) {
  BoundingBox box;
  for (const Vec3& v : mesh.vertices) box.enclose(v);
  return box;
}

/// The largest coordinate of the placed mesh.
double checked_extent(const TriangleMesh& mesh) {
  const BoundingBox box = bounds_of(mesh);
  const auto largest = [](const Vec3& v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); };
  const double extent = std::max(largest(box.min), largest(box.max));
  const double size = largest(box.max - box.min);
  if (!(extent <= 1e6)) throw std::invalid_argument("the mesh reaches beyond 1e6 m; see \"scale\" and \"translate\"");
  if (!(size >= 1e-6)) throw std::invalid_argument(fmt::format("the mesh is {:.3g} m in size; see \"scale\"", size));
  return extent;
}

/// A local minimum of the distance, as a triangle has it.
struct Candidate {
  double distance;
  Vec3 normal;
  std::int32_t feature;
  std::uint32_t triangle;
};

/// A total order, so that the search may find them in any.
bool is_nearer(const Candidate& a, const Candidate& b) {
  return std::tie(a.distance, a.feature, a.triangle) < std::tie(b.distance, b.feature, b.triangle);
}

/// Whether no triangle around an edge or a vertex comes nearer to the centre than that edge or vertex does. One that is
/// nearer by no more than rounding does not count, so that no centre falls between the regions of two features. Where
/// regions overlap, their normals are equal but for rounding and one touch counts.
bool is_nearest_around(const Mesh& mesh, std::uint32_t link, const Vec3& centre, double squared_distance) {
  const double bound = squared_distance - 2.0 * mesh.rounding * std::sqrt(squared_distance);
  const auto triangles = mesh.surface.around.row(link);
  return std::none_of(triangles.begin(), triangles.end(),
                      [&](std::uint32_t t) { return nearest_on(mesh.corners[t], centre).squared_distance < bound; });
}

Candidate candidate_at(const Mesh& mesh, std::int32_t feature, std::uint32_t triangle, const Vec3& centre,
                       const NearestOnTriangle& nearest) {
  const bool is_patch = mesh.features.is_patch(feature);
  const double d = std::sqrt(nearest.squared_distance);
  if (!is_patch && d > 0.0) return {d, (1.0 / d) * (centre - nearest.point), feature, triangle};
  const auto patch = static_cast<std::size_t>(mesh.features.of_triangle[triangle]);
  const auto [distance, normal] = touch(mesh.features.patches[patch], centre);
  return {is_patch ? distance : 0.0, normal, feature, triangle};
}

/// The reach of a search whose question is answered: it visits no more boxes but those around the centre itself.
constexpr double settled = 0.0;

using Candidates = std::pmr::vector<Candidate>;

void find_candidates(const Mesh& mesh, const Vec3& centre, double reach, Candidates& found) {
  const double search = reach + flatness(mesh);
  mesh.tree.visit_near(centre, search, [&](std::uint32_t t) {
    const NearestOnTriangle nearest = nearest_on(mesh.corners[t], centre);
    if (nearest.squared_distance > search * search) return search;
    std::int32_t feature = mesh.features.of_triangle[t];
    if (nearest.part > 0) {
      const std::uint32_t link = mesh.surface.triangles[t].link[nearest.part - 1];
      if (!is_nearest_around(mesh, link, centre, nearest.squared_distance)) return search;
      feature = mesh.features.of_link[link];
    }
    const Candidate candidate = candidate_at(mesh, feature, t, centre, nearest);
    if (candidate.distance < reach) found.push_back(candidate);
    return search;
  });
}

}  // namespace

double flatness(const Mesh& mesh) { return 4.0 * mesh.surface.tolerance; }

Mesh Mesh::made(const WallDeck& deck, const ReadFile& read_file) {
  const MeshPlacement placement = {deck.scale, deck.rotate_axis, deck.rotate_angle, deck.translate};
  return make_mesh(parse_stl(read_file(deck.file), deck.file), placement, deck.feature_angle);
}

Mesh make_mesh(const std::vector<Corners>& triangles, const MeshPlacement& placement, double feature_angle) {
  Mesh mesh;
  mesh.surface = make_triangle_mesh(triangles);
  place(placement, mesh.surface);
  mesh.rounding = 1e-14 * checked_extent(mesh.surface);
  mesh.cos_feature_angle = sin_cos_of_degrees(feature_angle).cosine;
  mesh.features = find_features(mesh.surface, mesh.cos_feature_angle);
  for (std::size_t t = 0; t < mesh.surface.triangles.size(); ++t) mesh.corners.push_back(mesh.surface.corners(t));
  mesh.tree = TriangleTree(mesh.corners);
  return mesh;
}

void find_touches(const Mesh& mesh, const Vec3& centre, double reach, int wall, TouchBuffer& out) {
  alignas(Candidate) std::array<std::byte, 8192> on_stack;  // enough but for very fine meshes
  std::pmr::monotonic_buffer_resource memory(on_stack.data(), on_stack.size());
  Candidates found(&memory);
  found.reserve(16);
  find_candidates(mesh, centre, reach, found);
  std::sort(found.begin(), found.end(), is_nearer);
  const int before = out.size();
  for (const Candidate& c : found) {
    const auto earlier = out.touches().subspan(static_cast<std::size_t>(before));
    const bool counted = std::any_of(earlier.begin(), earlier.end(), [&](const WallTouch& t) {
      return dot(t.normal, c.normal) > mesh.cos_feature_angle;
    });
    if (counted) continue;
    out.add({.distance = c.distance,
             .normal = c.normal,
             .point = centre - c.distance * c.normal,
             .wall = wall,
             .feature = c.feature,
             .on_face = mesh.features.is_patch(c.feature)});
  }
}

double distance(const Mesh& mesh, const Vec3& centre) {
  double least = 1e300;
  mesh.tree.visit_near(centre, 1e150, [&](std::uint32_t t) {
    least = std::min(least, nearest_on(mesh.corners[t], centre).squared_distance);
    return std::sqrt(least);
  });
  return std::sqrt(least);
}

bool is_within(const Mesh& mesh, const Vec3& centre, double reach) {
  const double search = reach + flatness(mesh);
  bool found = false;
  mesh.tree.visit_near(centre, search, [&](std::uint32_t t) {
    found = found || nearest_on(mesh.corners[t], centre).squared_distance < search * search;
    return found ? settled : search;
  });
  return found;
}

Face face_of(const Mesh& mesh, int feature) { return mesh.features.patches[static_cast<std::size_t>(feature)]; }

bool keeps_to_face(const Mesh& mesh, int feature, const Vec3& centre, double reach, double skin) {
  const auto [height, normal] = touch(mesh.features.patches[static_cast<std::size_t>(feature)], centre);
  const Vec3 projected = centre - height * normal;
  const double search = std::max(reach, height + 1.01 * skin) + flatness(mesh);
  bool keeps = true;
  mesh.tree.visit_near(centre, search, [&](std::uint32_t t) {
    if (mesh.features.of_triangle[t] != feature) {
      const double bound = reach + flatness(mesh);
      keeps = keeps && nearest_on(mesh.corners[t], centre).squared_distance > bound * bound;
      return keeps ? search : settled;
    }
    for (std::size_t k = 0; k < 3 && keeps; ++k) {
      if (mesh.features.is_patch(mesh.features.of_link[mesh.surface.triangles[t].link[k]])) continue;
      const Vec3& a = mesh.corners[t][k];
      const Vec3& b = mesh.corners[t][(k + 1) % 3];
      const Vec3 rim = a + nearest_along(a, b, projected) * (b - a);
      keeps = norm(rim - projected) > 1.01 * skin + flatness(mesh);
    }
    return keeps ? search : settled;
  });
  return keeps;
}

bool adjacent_features(const Mesh& mesh, int a, int b) {
  const MeshFeatures& f = mesh.features;
  const bool patches = f.is_patch(a) && f.is_patch(b);
  if (patches && f.surface[static_cast<std::size_t>(a)] == f.surface[static_cast<std::size_t>(b)]) return true;
  auto few = f.vertices.row(static_cast<std::size_t>(a));
  auto many = f.vertices.row(static_cast<std::size_t>(b));
  if (few.size() > many.size()) std::swap(few, many);
  return std::any_of(few.begin(), few.end(),
                     [&](std::uint32_t v) { return std::binary_search(many.begin(), many.end(), v); });
}

std::string describe(const Mesh& mesh) {
  const MeshDefects& d = mesh.surface.defects;
  const auto [low, high] = bounds_of(mesh.surface);
  const auto edges = [](std::size_t n) { return fmt::format("{} {}", n, n == 1 ? "edge" : "edges"); };
  return fmt::format(
      "{} triangles in {} flat patches; {} with one triangle, {} with more than two; dropped {} of zero "
      "area and {} duplicate; from ({:.4g}, {:.4g}, {:.4g}) to ({:.4g}, {:.4g}, {:.4g}) m",
      mesh.surface.triangles.size(), mesh.features.patches.size(), edges(d.open_edges), edges(d.crowded_edges),
      d.zero_area, d.duplicates, low.x, low.y, low.z, high.x, high.y, high.z);
}

}  // namespace repose
