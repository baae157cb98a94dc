#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/walls/triangle.h"

namespace repose {

/// A box with sides along the axes.
struct BoundingBox {
  Vec3 min{1e300, 1e300, 1e300};
  Vec3 max{-1e300, -1e300, -1e300};

  void enclose(const Vec3& p);
  void enclose(const Corners& corners);
};

/// Squared distance in m2 from a centre to a box; 0 inside.
inline double squared_distance(const BoundingBox& box, const Vec3& centre) {
  const auto beyond = [](double low, double x, double high) { return x < low ? low - x : x > high ? x - high : 0.0; };
  const double x = beyond(box.min.x, centre.x, box.max.x);
  const double y = beyond(box.min.y, centre.y, box.max.y);
  const double z = beyond(box.min.z, centre.z, box.max.z);
  return x * x + y * y + z * z;
}

/// Triangles in a binary tree of bounding boxes, halved at the median along the longest side, so that the tree is as
/// deep as the logarithm of their number, whatever their places.
class TriangleTree {
 public:
  TriangleTree() = default;
  explicit TriangleTree(std::span<const Corners> triangles);

  /// Calls visit(triangle) for the triangles whose leaf's box is within `reach` (m) of a centre. It returns the reach
  /// from then on, so that a search for the nearest may narrow it.
  template <class Visit>
  void visit_near(const Vec3& centre, double reach, Visit&& visit) const {
    if (nodes_.empty()) return;
    std::array<std::uint32_t, 64> stack;
    std::size_t depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
      const std::uint32_t n = stack[--depth];
      const Node& node = nodes_[n];
      if (squared_distance(node.box, centre) > reach * reach) continue;
      if (node.count == 0) {
        const std::uint32_t left = n + 1;
        const bool left_first =
            squared_distance(nodes_[left].box, centre) <= squared_distance(nodes_[node.first].box, centre);
        stack[depth++] = left_first ? node.first : left;
        stack[depth++] = left_first ? left : node.first;
        continue;
      }
      for (std::uint32_t k = node.first; k < node.first + node.count; ++k) reach = visit(order_[k]);
    }
  }

 private:
  struct Node {
    BoundingBox box;
    std::uint32_t first = 0;  // of its triangles in order_; of an inner node the right child (the left one is next)
    std::uint32_t count = 0;  // of an inner node 0
  };
  void build(std::span<const Corners> triangles, std::span<const Vec3> middles, std::uint32_t first,
             std::uint32_t count);

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
};

}  // namespace repose
