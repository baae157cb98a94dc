#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/vec3.h"
#include "comm/communicator.h"

namespace repose {

/// A plane across axis 0, 1 or 2 (x, y, z); what lies on it is above.
struct DividingPlane {
  int axis = 0;
  double position = 0.0;

  bool is_below(const Vec3& x) const { return along(x, axis) < position; }
  /// Signed distance, positive above.
  double offset(const Vec3& x) const { return along(x, axis) - position; }
  static double along(const Vec3& x, int axis) { return axis == 0 ? x.x : axis == 1 ? x.y : x.z; }
};

/// Particles of this rank, with their costs (positive) and, of each, the part in which it lies, or -1.
struct PartedParticles {
  std::span<const Vec3> positions;
  std::span<const std::int64_t> cost;
  std::span<const int> part;
};

/// Collective. A plane for each part, across the axis on which its cost, that of all ranks, is spread most (variance),
/// with the share of ranks/2 (rounded down) in `ranks` of it below. `ranks` of each part are at least 2, on all ranks
/// the same.
std::vector<DividingPlane> dividing_planes(const Communicator& comm, const PartedParticles& particles,
                                           std::span<const int> ranks);

}  // namespace repose
