#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/csr.h"
#include "scene/walls/triangle.h"

namespace repose {

/// What is not as it should be in a file of triangles.
struct MeshDefects {
  std::size_t zero_area = 0;      ///< triangles without an area, dropped
  std::size_t duplicates = 0;     ///< triangles of the same three vertices as one before, dropped
  std::size_t open_edges = 0;     ///< of one triangle
  std::size_t crowded_edges = 0;  ///< of more than two triangles

  bool any() const { return zero_area + duplicates + open_edges + crowded_edges > 0; }
};

/// Triangles that share vertices and edges. Links are what triangles can share: first the edges, then the vertices.
struct TriangleMesh {
  struct Triangle {
    std::array<std::uint32_t, 3> vertex;
    std::array<std::uint32_t, 6> link;  ///< the edges from corner k to the next, the corners
  };

  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;
  std::size_t edges = 0;
  Csr<std::uint32_t> around;  ///< the triangles of each link
  double tolerance = 0.0;     ///< rounding of single precision at the farthest vertex, in the unit of length
  MeshDefects defects;

  Corners corners(std::size_t t) const {
    const auto& v = triangles[t].vertex;
    return {vertices[v[0]], vertices[v[1]], vertices[v[2]]};
  }
};

/// Joins corners that are equal within the rounding of single precision, 2^-22 of the largest coordinate, and drops
/// triangles that have no area then or repeat one before. std::invalid_argument when none is left.
TriangleMesh make_triangle_mesh(const std::vector<Corners>& triangles);

}  // namespace repose
