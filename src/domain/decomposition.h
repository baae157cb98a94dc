#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/vec3.h"
#include "comm/communicator.h"
#include "domain/dividing_planes.h"

namespace repose {

/// Space divided among the ranks by recursive coordinate bisection: a binary tree of planes whose leaves, one per rank,
/// carry about the same cost. Every rank holds the whole tree. The outermost boxes have no outer limit.
class Decomposition {
 public:
  /// Everything belongs to rank 0.
  explicit Decomposition(int ranks = 1);

  /// Collective. Bisects the particles of all ranks, each with a cost (positive), each part along the axis on which its
  /// cost is spread most (variance): a few scattered particles make a side long, but do not call for a plane across it.
  static Decomposition bisect(const Communicator& comm, std::span<const Vec3> positions,
                              std::span<const std::int64_t> cost) {
    return bisect(comm, comm.size(), positions, cost);
  }
  /// Collective. The same for any number of `parts`.
  static Decomposition bisect(const Communicator& comm, int parts, std::span<const Vec3> positions,
                              std::span<const std::int64_t> cost);

  int owner(const Vec3& position) const;

  /// Calls visit(rank, squared distance) for every rank whose box is nearer to `position` than `distance`.
  template <class Visit>
  void for_each_rank_near(const Vec3& position, double distance, Visit&& visit) const {
    descend(0, position, distance * distance, Vec3{}, visit);
  }

 private:
  struct Node {
    int first_rank;  ///< lowest rank of this part
    int ranks;       ///< how many
    DividingPlane plane = {};
    int below = -1;  ///< child nodes, -1 at a leaf
    int above = -1;
  };

  /// `away` is the distance, axis by axis, that the planes passed so far put between the position and this part.
  template <class Visit>
  void descend(int index, const Vec3& position, double limit, const Vec3& away, Visit& visit) const {
    const double distance = squared_norm(away);
    if (distance >= limit) return;
    const Node& node = nodes_[static_cast<std::size_t>(index)];
    if (node.below < 0) {
      visit(node.first_rank, distance);
      return;
    }
    const double over = node.plane.offset(position);  // positive: on the upper side
    descend(node.below, position, limit, over < 0.0 ? away : with(away, node.plane.axis, over), visit);
    descend(node.above, position, limit, over < 0.0 ? with(away, node.plane.axis, -over) : away, visit);
  }
  static Vec3 with(Vec3 v, int axis, double value) {
    (axis == 0 ? v.x : axis == 1 ? v.y : v.z) = value;
    return v;
  }
  void place_planes(const Communicator& comm, std::span<const int> parts, std::span<const Vec3> positions,
                    std::span<const std::int64_t> cost, std::span<const int> part_of);

  std::vector<Node> nodes_;
};

}  // namespace repose
