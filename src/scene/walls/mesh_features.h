#pragma once

#include <cstdint>
#include <vector>

#include "base/csr.h"
#include "scene/walls/triangle_mesh.h"
#include "scene/walls/wall_face.h"

namespace repose {

/// What a sphere can feel of a mesh, numbered through: flat patches, then the edges and vertices between them and at
/// the rim. An edge or a vertex inside a patch is no feature of its own but part of it.
struct MeshFeatures {
  std::vector<FlatFace> patches;
  std::vector<std::int32_t> of_triangle;  ///< the patch of each triangle
  std::vector<std::int32_t> of_link;      ///< the feature that each edge and vertex of the mesh is, or is a part of
  std::vector<std::int32_t> surface;      ///< of each patch: equal for patches joined by turns below the feature angle
  Csr<std::uint32_t> vertices;            ///< of each feature, those at its ends or its rim, in ascending order

  bool is_patch(std::int32_t feature) const { return feature < static_cast<std::int32_t>(patches.size()); }
};

/// Patches grow from the largest triangles over neighbours whose vertices lie in the plane within the tolerance of the
/// mesh, so that rounding of the file's coordinates does not break up what is flat. `cos_feature_angle` is that of the
/// greatest turn within a smooth surface.
MeshFeatures find_features(const TriangleMesh& mesh, double cos_feature_angle);

}  // namespace repose
