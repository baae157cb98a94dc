#include "scene/walls/triangle_tree.h"

#include <algorithm>
#include <numeric>

namespace repose {

namespace {

constexpr std::uint32_t leaf_size = 4;

}  // namespace

void BoundingBox::enclose(const Vec3& p) {
  min = {std::min(min.x, p.x), std::min(min.y, p.y), std::min(min.z, p.z)};
  max = {std::max(max.x, p.x), std::max(max.y, p.y), std::max(max.z, p.z)};
}

void BoundingBox::enclose(const Corners& corners) {
  for (const Vec3& corner : corners) enclose(corner);
}

TriangleTree::TriangleTree(std::span<const Corners> triangles) : order_(triangles.size()) {
  std::iota(order_.begin(), order_.end(), 0U);
  std::vector<Vec3> middles;
  for (const Corners& c : triangles) middles.push_back((1.0 / 3.0) * (c[0] + c[1] + c[2]));
  if (!triangles.empty()) build(triangles, middles, 0, static_cast<std::uint32_t>(triangles.size()));
}

void TriangleTree::build(std::span<const Corners> triangles, std::span<const Vec3> middles, std::uint32_t first,
                         std::uint32_t count) {
  Node node;
  BoundingBox of_middles;
  for (std::uint32_t k = first; k < first + count; ++k) {
    node.box.enclose(triangles[order_[k]]);
    of_middles.enclose(middles[order_[k]]);
  }
  const std::size_t here = nodes_.size();
  nodes_.push_back(node);
  if (count <= leaf_size) {
    nodes_[here].first = first;
    nodes_[here].count = count;
    return;
  }
  const Vec3 size = of_middles.max - of_middles.min;
  const auto axis = size.x >= size.y && size.x >= size.z ? &Vec3::x : size.y >= size.z ? &Vec3::y : &Vec3::z;
  const auto begin = order_.begin() + first;
  std::nth_element(begin, begin + count / 2, begin + count, [&](std::uint32_t a, std::uint32_t b) {
    return middles[a].*axis != middles[b].*axis ? middles[a].*axis < middles[b].*axis : a < b;
  });
  build(triangles, middles, first, count / 2);
  nodes_[here].first = static_cast<std::uint32_t>(nodes_.size());
  build(triangles, middles, first + count / 2, count - count / 2);
}

}  // namespace repose
