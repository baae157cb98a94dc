#include "domain/decomposition.h"

#include <algorithm>

#include "base/index.h"

namespace repose {

Decomposition::Decomposition(int ranks) { nodes_.push_back({0, ranks}); }

int Decomposition::owner(const Vec3& position) const {
  const Node* node = &nodes_[0];
  while (node->below >= 0) {
    node = &nodes_[index(node->plane.is_below(position) ? node->below : node->above)];
  }
  return node->first_rank;
}

Decomposition Decomposition::bisect(const Communicator& comm, int parts, std::span<const Vec3> positions,
                                    std::span<const std::int64_t> cost) {
  Decomposition tree(parts);
  std::vector<int> part_of(positions.size(), 0);
  for (std::vector<int> level = {0}; !level.empty();) {
    std::vector<int> divisible;
    for (const int part : level) {
      if (tree.nodes_[index(part)].ranks > 1) divisible.push_back(part);
    }
    tree.place_planes(comm, divisible, positions, cost, part_of);
    level.clear();
    for (const int part : divisible) {
      const Node node = tree.nodes_[index(part)];
      const int half = node.ranks / 2;
      tree.nodes_[index(part)].below = static_cast<int>(tree.nodes_.size());
      tree.nodes_[index(part)].above = static_cast<int>(tree.nodes_.size()) + 1;
      tree.nodes_.push_back({node.first_rank, half});
      tree.nodes_.push_back({node.first_rank + half, node.ranks - half});
      level.push_back(tree.nodes_[index(part)].below);
      level.push_back(tree.nodes_[index(part)].above);
    }
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const Node& node = tree.nodes_[index(part_of[i])];
      if (node.below >= 0) part_of[i] = node.plane.is_below(positions[i]) ? node.below : node.above;
    }
  }
  return tree;
}

/// Places the dividing planes of all `parts` of one level together.
void Decomposition::place_planes(const Communicator& comm, std::span<const int> parts, std::span<const Vec3> positions,
                                 std::span<const std::int64_t> cost, std::span<const int> part_of) {
  if (parts.empty()) return;
  std::vector<int> row(nodes_.size(), -1);  // of each part, or -1
  std::vector<int> ranks;
  for (const int part : parts) {
    row[index(part)] = static_cast<int>(ranks.size());
    ranks.push_back(nodes_[index(part)].ranks);
  }
  std::vector<int> row_of(part_of.size());
  std::transform(part_of.begin(), part_of.end(), row_of.begin(), [&](int part) { return row[index(part)]; });
  const std::vector<DividingPlane> planes = dividing_planes(comm, {positions, cost, row_of}, ranks);
  for (std::size_t p = 0; p < parts.size(); ++p) nodes_[index(parts[p])].plane = planes[p];
}

}  // namespace repose
