#include "scene/walls/mesh_features.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace repose {

namespace {

/// The mean plane of triangles, weighted by their areas; which way round their corners run does not matter.
class MeanPlane {
 public:
  explicit MeanPlane(const Corners& first) : origin_(first[0]) { add(first); }

  void add(const Corners& corners) {
    const Vec3 area = area_vector(corners);
    const double weight = norm(area);
    areas_ += dot(area, areas_) < 0.0 ? -area : area;
    weights_ += weight;
    for (const Vec3& corner : corners) moments_ += (weight / 3.0) * (corner - origin_);
  }
  FlatFace face() const {
    const double length = norm(areas_);
    return {origin_ + (1.0 / weights_) * moments_, {areas_.x / length, areas_.y / length, areas_.z / length}};
  }
  bool holds(const Corners& corners, double tolerance) const {
    const FlatFace plane = face();
    return std::all_of(corners.begin(), corners.end(),
                       [&](const Vec3& p) { return std::fabs(dot(p - plane.point, plane.normal)) <= tolerance; });
  }

 private:
  Vec3 origin_;
  Vec3 areas_;
  Vec3 moments_;
  double weights_ = 0.0;
};

constexpr std::int32_t none = -1;

/// The triangles that can be reached from the seed, edge by edge, within one plane.
FlatFace grow_patch(const TriangleMesh& mesh, std::uint32_t seed, std::int32_t patch, std::vector<std::int32_t>& of) {
  MeanPlane plane(mesh.corners(seed));
  std::vector<std::uint32_t> queue = {seed};
  of[seed] = patch;
  for (std::size_t next = 0; next < queue.size(); ++next) {
    for (std::size_t k = 0; k < 3; ++k) {
      for (const std::uint32_t t : mesh.around.row(mesh.triangles[queue[next]].link[k])) {
        const Corners corners = mesh.corners(t);
        if (of[t] != none || !plane.holds(corners, mesh.tolerance)) continue;
        of[t] = patch;
        plane.add(corners);
        queue.push_back(t);
      }
    }
  }
  return plane.face();
}

void find_patches(const TriangleMesh& mesh, MeshFeatures& features) {
  std::vector<double> area(mesh.triangles.size());
  for (std::size_t t = 0; t < area.size(); ++t) area[t] = norm(area_vector(mesh.corners(t)));
  std::vector<std::uint32_t> order(area.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return area[a] != area[b] ? area[a] > area[b] : a < b; });
  features.of_triangle.assign(area.size(), none);
  for (const std::uint32_t seed : order) {
    if (features.of_triangle[seed] != none) continue;
    const auto patch = static_cast<std::int32_t>(features.patches.size());
    features.patches.push_back(grow_patch(mesh, seed, patch, features.of_triangle));
  }
}

/// Edges and vertices within a patch belong to it; the others become features.
void number_links(const TriangleMesh& mesh, MeshFeatures& features) {
  const std::size_t links = mesh.around.rows();
  features.of_link.assign(links, none);
  std::vector<bool> at_rim(mesh.vertices.size(), false);
  const auto patch_around = [&](std::size_t l) {
    const auto triangles = mesh.around.row(l);
    if (triangles.empty()) return none;
    const std::int32_t patch = features.of_triangle[triangles.front()];
    const auto same = [&](std::uint32_t t) { return features.of_triangle[t] == patch; };
    return std::all_of(triangles.begin(), triangles.end(), same) ? patch : none;
  };
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t e = t.link[k];
      const bool inside = mesh.around.row(e).size() > 1 && patch_around(e) != none;
      if (inside) features.of_link[e] = patch_around(e);
      if (!inside) at_rim[t.vertex[k]] = at_rim[t.vertex[(k + 1) % 3]] = true;
    }
  }
  auto next = static_cast<std::int32_t>(features.patches.size());
  for (std::size_t l = 0; l < links; ++l) {
    const bool is_vertex = l >= mesh.edges;
    if (is_vertex && !at_rim[l - mesh.edges]) features.of_link[l] = patch_around(l);
    if (features.of_link[l] == none) features.of_link[l] = next++;
  }
}

void list_vertices(const TriangleMesh& mesh, MeshFeatures& features) {
  const auto count = static_cast<std::size_t>(1 + *std::max_element(features.of_link.begin(), features.of_link.end()));
  const std::size_t rows = std::max(count, features.patches.size());
  const auto visit_rims = [&](const auto& add) {
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto patch = static_cast<std::size_t>(features.of_triangle[t]);
      for (std::size_t k = 0; k < 3; ++k) {
        const std::int32_t edge = features.of_link[mesh.triangles[t].link[k]];
        if (features.is_patch(edge)) continue;
        for (const std::uint32_t v : {mesh.triangles[t].vertex[k], mesh.triangles[t].vertex[(k + 1) % 3]}) {
          add(patch, v);
          add(static_cast<std::size_t>(edge), v);
          add(static_cast<std::size_t>(features.of_link[mesh.edges + v]), v);
        }
      }
    }
  };
  Csr<std::uint32_t> all = Csr<std::uint32_t>::group(rows, visit_rims);
  for (std::size_t f = 0; f < rows; ++f) {
    std::vector<std::uint32_t> row(all.row(f).begin(), all.row(f).end());
    std::sort(row.begin(), row.end());
    row.erase(std::unique(row.begin(), row.end()), row.end());
    features.vertices.append_row(row);
  }
}

/// Unit, in the plane of the triangle, away from its edge k to its inside.
Vec3 inwards(const TriangleMesh& mesh, std::uint32_t t, std::uint32_t edge) {
  const Corners c = mesh.corners(t);
  const auto& links = mesh.triangles[t].link;
  const auto k = static_cast<std::size_t>(std::find(links.begin(), links.begin() + 3, edge) - links.begin());
  const Vec3 in = cross(area_vector(c), c[(k + 1) % 3] - c[k]);
  return (1.0 / norm(in)) * in;
}

/// Joins the patches on both sides of edges that turn little.
void find_surfaces(const TriangleMesh& mesh, double cos_feature_angle, MeshFeatures& features) {
  std::vector<std::int32_t>& parent = features.surface;
  parent.resize(features.patches.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](std::int32_t p) {
    while (parent[static_cast<std::size_t>(p)] != p) {
      std::int32_t& above = parent[static_cast<std::size_t>(p)];
      p = above = parent[static_cast<std::size_t>(above)];
    }
    return p;
  };
  for (std::uint32_t e = 0; e < mesh.edges; ++e) {
    const auto triangles = mesh.around.row(e);
    if (triangles.size() != 2 || features.is_patch(features.of_link[e])) continue;
    if (-dot(inwards(mesh, triangles[0], e), inwards(mesh, triangles[1], e)) <= cos_feature_angle) continue;
    const std::int32_t a = root(features.of_triangle[triangles[0]]);
    const std::int32_t b = root(features.of_triangle[triangles[1]]);
    parent[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
  }
  for (std::size_t p = 0; p < parent.size(); ++p) parent[p] = root(static_cast<std::int32_t>(p));
}

}  // namespace

MeshFeatures find_features(const TriangleMesh& mesh, double cos_feature_angle) {
  MeshFeatures features;
  find_patches(mesh, features);
  number_links(mesh, features);
  list_vertices(mesh, features);
  find_surfaces(mesh, cos_feature_angle, features);
  return features;
}

}  // namespace repose
