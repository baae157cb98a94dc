#include "scene/walls/triangle_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace repose {

namespace {

double largest_coordinate(const std::vector<Corners>& triangles) {
  double largest = 0.0;
  for (const Corners& corners : triangles) {
    for (const Vec3& p : corners) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  }
  return largest;
}

/// Gives points their numbers: the same to points nearer to one another than the tolerance. A point is looked for in
/// those cells of a grid that it is near enough to; a cell holds few, as it is a few tolerances wide.
class Welder {
 public:
  Welder(double tolerance, std::vector<Vec3>& vertices) : tolerance_(tolerance), vertices_(vertices) {}

  std::uint32_t number_of(const Vec3& p) {
    std::uint32_t nearest = none;
    for_each_cell_near(p, [&](const Cell& cell) {
      const auto found = first_in_.find(cell);
      for (std::uint32_t v = found == first_in_.end() ? none : found->second; v != none; v = next_[v]) {
        if (norm(vertices_[v] - p) <= tolerance_) nearest = std::min(nearest, v);
      }
    });
    return nearest != none ? nearest : add(p);
  }

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  using Cell = std::array<std::int64_t, 3>;
  struct Hash {
    std::size_t operator()(const Cell& c) const {
      std::uint64_t h = 0;
      for (const std::int64_t i : c) {
        h = (h ^ static_cast<std::uint64_t>(i)) * 0x9E3779B97F4A7C15;
        h ^= h >> 32;
      }
      return h;
    }
  };

  std::int64_t cell_of(double x) const { return static_cast<std::int64_t>(std::floor(x / (4.0 * tolerance_))); }

  template <class Visit>
  void for_each_cell_near(const Vec3& p, Visit&& visit) const {
    const double t = tolerance_;
    for (std::int64_t i = cell_of(p.x - t); i <= cell_of(p.x + t); ++i) {
      for (std::int64_t j = cell_of(p.y - t); j <= cell_of(p.y + t); ++j) {
        for (std::int64_t k = cell_of(p.z - t); k <= cell_of(p.z + t); ++k) visit(Cell{i, j, k});
      }
    }
  }

  std::uint32_t add(const Vec3& p) {
    const auto v = static_cast<std::uint32_t>(vertices_.size());
    vertices_.push_back(p);
    const auto [cell, is_new] = first_in_.try_emplace({cell_of(p.x), cell_of(p.y), cell_of(p.z)}, v);
    next_.push_back(is_new ? none : std::exchange(cell->second, v));
    return v;
  }

  double tolerance_;
  std::vector<Vec3>& vertices_;
  std::unordered_map<Cell, std::uint32_t, Hash> first_in_;
  std::vector<std::uint32_t> next_;  // in the same cell
};

/// False also when the height over the longest side is no more than rounding.
bool has_area(const Corners& c) {
  const double longest2 = std::max({squared_norm(c[1] - c[0]), squared_norm(c[2] - c[1]), squared_norm(c[0] - c[2])});
  return norm(area_vector(c)) > 1e-12 * longest2;
}

void drop_without_area(TriangleMesh& mesh) {
  std::vector<TriangleMesh::Triangle> kept;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (has_area(mesh.corners(t))) kept.push_back(mesh.triangles[t]);
  }
  mesh.defects.zero_area = mesh.triangles.size() - kept.size();
  mesh.triangles = std::move(kept);
}

void drop_duplicates(TriangleMesh& mesh) {
  using Sorted = std::pair<std::array<std::uint32_t, 3>, std::size_t>;  // vertices in ascending order, triangle
  std::vector<Sorted> all;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<std::uint32_t, 3> v = mesh.triangles[t].vertex;
    std::sort(v.begin(), v.end());
    all.emplace_back(v, t);
  }
  std::sort(all.begin(), all.end());
  std::vector<bool> is_duplicate(all.size(), false);
  for (std::size_t i = 1; i < all.size(); ++i) {
    if (all[i].first == all[i - 1].first) is_duplicate[all[i].second] = true;
  }
  std::vector<TriangleMesh::Triangle> kept;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!is_duplicate[t]) kept.push_back(mesh.triangles[t]);
  }
  mesh.defects.duplicates = mesh.triangles.size() - kept.size();
  mesh.triangles = std::move(kept);
}

/// Numbers the edges in the order of their vertices.
void number_edges(TriangleMesh& mesh) {
  struct Side {
    std::array<std::uint32_t, 2> ends;  // in ascending order
    std::uint32_t triangle;
    std::uint32_t k;
  };
  std::vector<Side> sides;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& v = mesh.triangles[t].vertex;
    for (std::uint32_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(v[k], v[(k + 1) % 3]);
      sides.push_back({{low, high}, t, k});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.ends, a.triangle, a.k) < std::tie(b.ends, b.triangle, b.k);
  });
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (i == 0 || sides[i].ends != sides[i - 1].ends) ++mesh.edges;
    mesh.triangles[sides[i].triangle].link[sides[i].k] = static_cast<std::uint32_t>(mesh.edges - 1);
  }
}

void link(TriangleMesh& mesh) {
  number_edges(mesh);
  for (TriangleMesh::Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) t.link[3 + k] = static_cast<std::uint32_t>(mesh.edges + t.vertex[k]);
  }
  mesh.around = Csr<std::uint32_t>::group(mesh.edges + mesh.vertices.size(), [&](const auto& add) {
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      for (const std::uint32_t l : mesh.triangles[t].link) add(l, t);
    }
  });
  for (std::size_t e = 0; e < mesh.edges; ++e) {
    const std::size_t triangles = mesh.around.row(e).size();
    mesh.defects.open_edges += triangles == 1 ? 1 : 0;
    mesh.defects.crowded_edges += triangles > 2 ? 1 : 0;
  }
}

}  // namespace

TriangleMesh make_triangle_mesh(const std::vector<Corners>& triangles) {
  TriangleMesh mesh;
  mesh.tolerance = std::max(0x1p-22 * largest_coordinate(triangles), 1e-100);
  Welder welder(mesh.tolerance, mesh.vertices);
  mesh.triangles.reserve(triangles.size());
  for (const Corners& c : triangles) {
    const std::uint32_t a = welder.number_of(c[0]);
    const std::uint32_t b = welder.number_of(c[1]);
    mesh.triangles.push_back({{a, b, welder.number_of(c[2])}, {}});
  }
  drop_without_area(mesh);
  drop_duplicates(mesh);
  if (mesh.triangles.empty()) throw std::invalid_argument("no triangle with an area");
  link(mesh);
  return mesh;
}

}  // namespace repose
