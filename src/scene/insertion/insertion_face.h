#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/philox.h"
#include "scene/insertion/region.h"
#include "scene/walls/triangle.h"
#include "scene/walls/wall.h"

namespace repose {

/// A flat face through which particles enter, of any outline.
struct InsertionFace {
  std::vector<Corners> triangles;
  std::vector<double> area_up_to;         ///< m2, of the triangles up to each
  std::vector<std::array<Vec3, 2>> rims;  ///< edges of one triangle alone
};

/// The face that a mesh or rectangle is. DeckError, naming the wall, when it is something else or not flat within 1e-6
/// of its size.
InsertionFace make_insertion_face(const Wall& wall);

Box bounds(const InsertionFace& face);

/// A random place for a sphere, as that of region.h: the face holds its centre and the circle it cuts.
std::optional<Vec3> random_place(const InsertionFace& face, double radius, std::uint64_t seed, std::int64_t id,
                                 RandomStream stream, std::uint32_t k);

}  // namespace repose
