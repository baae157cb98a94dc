#include "domain/decomposition.h"

#include <algorithm>
#include <limits>

namespace repose {
namespace {

constexpr std::size_t bins = 128;  // of each histogram
constexpr int refinements = 4;     // histograms per plane: 128^4 steps of the part's length

constexpr double places = 4096;  // along a side, so few that sums of squares of 1e10 particles do not wrap

constexpr double infinite = std::numeric_limits<double>::infinity();

std::size_t index(int i) { return static_cast<std::size_t>(i); }

}  // namespace

Decomposition::Decomposition(int ranks) { nodes_.push_back({0, ranks}); }

int Decomposition::owner(const Vec3& position) const {
  const Node* node = &nodes_[0];
  while (node->below >= 0) {
    node = &nodes_[index(along(position, node->axis) < node->plane ? node->below : node->above)];
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
      if (node.below >= 0) part_of[i] = along(positions[i], node.axis) < node.plane ? node.below : node.above;
    }
  }
  return tree;
}

/// Finds the dividing planes of all `parts` of one level together: per part a histogram of the cost along the axis on
/// which it is spread most, refined around the bin where the share of the lower half is reached.
void Decomposition::place_planes(const Communicator& comm, std::span<const int> parts, std::span<const Vec3> positions,
                                 std::span<const std::int64_t> cost, std::span<const int> part_of) {
  if (parts.empty()) return;
  std::vector<int> row(nodes_.size(), -1);  // of each part, or -1
  for (std::size_t p = 0; p < parts.size(); ++p) row[index(parts[p])] = static_cast<int>(p);

  // Bounding boxes as maxima: (x, y, z, -x, -y, -z) per part.
  std::vector<double> extent(6 * parts.size(), -infinite);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const int p = row[index(part_of[i])];
    if (p < 0) continue;
    for (int axis = 0; axis < 3; ++axis) {
      double* e = &extent[6 * index(p) + index(axis)];
      e[0] = std::max(e[0], along(positions[i], axis));
      e[3] = std::max(e[3], -along(positions[i], axis));
    }
  }
  comm.max_elements(std::span(extent.begin(), extent.end()));

  // Moments of the cost along each side, in integers: (cost, sums of cost times place, of cost times its square).
  const auto low_end = [&](std::size_t p, int axis) { return -extent[6 * p + 3 + index(axis)]; };
  const auto length = [&](std::size_t p, int axis) { return extent[6 * p + index(axis)] - low_end(p, axis); };
  std::vector<std::int64_t> moments(9 * parts.size(), 0);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const int part = row[index(part_of[i])];
    if (part < 0) continue;
    const std::size_t p = index(part);
    for (int axis = 0; axis < 3; ++axis) {
      if (!(length(p, axis) > 0.0)) continue;
      const double share = (along(positions[i], axis) - low_end(p, axis)) / length(p, axis);
      const auto place = static_cast<std::int64_t>(share * places);
      std::int64_t* m = &moments[9 * p + 3 * index(axis)];
      m[0] += cost[i];
      m[1] += cost[i] * place;
      m[2] += cost[i] * place * place;
    }
  }
  comm.sum_elements(std::span(moments.begin(), moments.end()));

  std::vector<double> low(parts.size(), 0.0);
  std::vector<double> width(parts.size(), 0.0);
  for (std::size_t p = 0; p < parts.size(); ++p) {
    Node& node = nodes_[index(parts[p])];
    double most = -1.0;
    for (int axis = 0; axis < 3; ++axis) {
      const std::int64_t* m = &moments[9 * p + 3 * index(axis)];
      if (m[0] == 0) continue;  // also leaves out parts without particles
      const double mean = static_cast<double>(m[1]) / static_cast<double>(m[0]);
      const double variance = static_cast<double>(m[2]) / static_cast<double>(m[0]) - mean * mean;
      const double spread = variance * length(p, axis) * length(p, axis);
      if (spread <= most) continue;
      most = spread;
      node.axis = axis;
      width[p] = length(p, axis);
      low[p] = low_end(p, axis);
    }
  }

  std::vector<std::int64_t> below(parts.size(), 0);   // cost under the interval
  std::vector<std::int64_t> target(parts.size(), 0);  // cost that the lower half shall have
  for (int round = 0; round < refinements; ++round) {
    std::vector<std::int64_t> histogram(bins * parts.size(), 0);
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const int p = row[index(part_of[i])];
      if (p < 0 || width[index(p)] <= 0.0) continue;
      const double at = (along(positions[i], nodes_[index(part_of[i])].axis) - low[index(p)]) / width[index(p)];
      if (at < 0.0 || (round > 0 && at >= 1.0)) continue;
      const auto bin = static_cast<std::size_t>(at * static_cast<double>(bins));
      histogram[bins * index(p) + std::min(bin, bins - 1)] += cost[i];
    }
    comm.sum_elements(std::span(histogram.begin(), histogram.end()));
    for (std::size_t p = 0; p < parts.size(); ++p) {
      const std::int64_t* h = &histogram[bins * p];
      const Node& node = nodes_[index(parts[p])];
      if (round == 0) {
        std::int64_t total = 0;
        for (std::size_t b = 0; b < bins; ++b) total += h[b];
        target[p] = total * (node.ranks / 2) / node.ranks;
      }
      std::size_t bin = 0;
      while (bin + 1 < bins && below[p] + h[bin] < target[p]) below[p] += h[bin++];
      width[p] /= static_cast<double>(bins);
      low[p] += static_cast<double>(bin) * width[p];
    }
  }
  for (std::size_t p = 0; p < parts.size(); ++p) nodes_[index(parts[p])].plane = low[p] + width[p];
}

}  // namespace repose
