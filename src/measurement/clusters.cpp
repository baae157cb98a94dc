#include "measurement/clusters.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace repose {
namespace {

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

/// Disjoint sets with path halving; the root of a set is its lowest member.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t i, std::size_t j) {
    i = root(i);
    j = root(j);
    parent_[std::max(i, j)] = std::min(i, j);
  }

 private:
  std::vector<std::size_t> parent_;
};

struct Cell {
  std::int64_t x, y, z;
  bool operator==(const Cell&) const = default;
};

struct CellHash {
  std::size_t operator()(const Cell& c) const {
    std::uint64_t h = 0;
    for (const std::int64_t k : {c.x, c.y, c.z}) {
      h = (h ^ static_cast<std::uint64_t>(k)) * 0x9e3779b97f4a7c15u;
      h ^= h >> 29;
    }
    return h;
  }
};

Cell cell_of(const Vec3& p, double size) {
  const auto index = [size](double x) { return static_cast<std::int64_t>(std::floor(x / size)); };
  return {index(p.x), index(p.y), index(p.z)};
}

/// One cell grid for the grains whose diameter is at most one cell and more than half of it: a single grid with cells
/// of the largest diameter would hold crowds of small grains in each cell.
struct Level {
  double cell_size;
  std::unordered_map<Cell, std::size_t, CellHash> first;  ///< in each cell; the grain inserted before follows
};

bool touch(const Sphere& a, const Sphere& b, double gap) {
  const double reach = a.radius + b.radius + gap * 2.0 * std::min(a.radius, b.radius);
  return squared_norm(a.centre - b.centre) <= reach * reach;
}

std::vector<std::size_t> by_falling_radius(std::span<const Sphere> grains) {
  std::vector<std::size_t> order(grains.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return grains[i].radius > grains[j].radius; });
  return order;
}

/// Joins every touching pair. Each grain, the largest first, looks among those inserted before it: they are at least as
/// large, so that the cells of their levels are wider than its reach and the 27 cells around its centre are enough.
void join_touching(std::span<const Sphere> grains, double gap, DisjointSets& sets) {
  std::vector<Level> levels;
  std::vector<std::size_t> next(grains.size(), none);
  for (const std::size_t i : by_falling_radius(grains)) {
    const Sphere& grain = grains[i];
    const double own_size = 2.0 * grain.radius * (1.0 + gap);
    if (levels.empty() || own_size <= 0.5 * levels.back().cell_size) levels.push_back({own_size, {}});
    for (const Level& level : levels) {
      const Cell c = cell_of(grain.centre, level.cell_size);
      for (int k = 0; k < 27; ++k) {
        const auto found = level.first.find({c.x + k % 3 - 1, c.y + k / 3 % 3 - 1, c.z + k / 9 - 1});
        if (found == level.first.end()) continue;
        for (std::size_t j = found->second; j != none; j = next[j]) {
          if (touch(grain, grains[j], gap)) sets.join(i, j);
        }
      }
    }
    Level& own = levels.back();
    const auto [slot, inserted] = own.first.try_emplace(cell_of(grain.centre, own.cell_size), i);
    if (!inserted) next[i] = std::exchange(slot->second, i);
  }
}

}  // namespace

std::vector<std::size_t> touching_clusters(std::span<const Sphere> grains, double gap) {
  DisjointSets sets(grains.size());
  join_touching(grains, gap, sets);
  std::vector<std::size_t> cluster(grains.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < grains.size(); ++i) {
    const std::size_t root = sets.root(i);
    cluster[i] = root == i ? count++ : cluster[root];
  }
  return cluster;
}

}  // namespace repose
