#include "scene/overlap.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <unordered_map>
#include <vector>

namespace repose {

namespace {

struct Cell {
  std::int64_t x, y, z;
  bool operator==(const Cell&) const = default;
};

struct CellHash {
  std::size_t operator()(const Cell& cell) const {
    std::uint64_t h = static_cast<std::uint64_t>(cell.x) * 0x9E3779B97F4A7C15u;
    h = (h ^ (h >> 29) ^ static_cast<std::uint64_t>(cell.y)) * 0xBF58476D1CE4E5B9u;
    h = (h ^ (h >> 32) ^ static_cast<std::uint64_t>(cell.z)) * 0x94D049BB133111EBu;
    return h ^ (h >> 31);
  }
};

// The spheres with radius in [2^(level-1), 2^level) in cells of 2^(level+1), the greatest diameter: whatever touches
// one of them and is not larger is at most one cell away.
class Grid {
 public:
  explicit Grid(int level) : level_(level), cell_size_(std::ldexp(2.0, level)) {}

  int level() const { return level_; }
  void add(const Vec3& position, std::size_t index) { cells_[cell_of(position)].push_back(index); }

  template <class Visit>
  void visit_around(const Vec3& position, Visit&& visit) const {
    const Cell home = cell_of(position);
    for (std::int64_t dx = -1; dx <= 1; ++dx) {
      for (std::int64_t dy = -1; dy <= 1; ++dy) {
        for (std::int64_t dz = -1; dz <= 1; ++dz) {
          const auto cell = cells_.find({home.x + dx, home.y + dy, home.z + dz});
          if (cell != cells_.end()) std::for_each(cell->second.begin(), cell->second.end(), visit);
        }
      }
    }
  }

 private:
  Cell cell_of(const Vec3& p) const { return {cell(p.x), cell(p.y), cell(p.z)}; }
  std::int64_t cell(double x) const {
    return static_cast<std::int64_t>(std::clamp(std::floor(x / cell_size_), -1e15, 1e15));
  }

  int level_;
  double cell_size_;
  std::unordered_map<Cell, std::vector<std::size_t>, CellHash> cells_;
};

int level_of(double radius) {
  int exponent = 0;
  std::frexp(radius, &exponent);
  return exponent;
}

}  // namespace

void for_each_overlap(std::span<const Vec3> position, std::span<const double> radius,
                      const std::function<void(std::size_t, std::size_t)>& found) {
  // From large to small, so that each sphere meets those of its own level and of the larger ones.
  std::vector<std::size_t> order(radius.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return level_of(radius[a]) > level_of(radius[b]); });
  std::vector<Grid> grids;
  for (const std::size_t i : order) {
    if (grids.empty() || grids.back().level() != level_of(radius[i])) grids.emplace_back(level_of(radius[i]));
    for (const Grid& grid : grids) {
      grid.visit_around(position[i], [&](std::size_t j) {
        const double sum = radius[i] + radius[j];
        if (squared_norm(position[i] - position[j]) < sum * sum) found(std::max(i, j), std::min(i, j));
      });
    }
    grids.back().add(position[i], i);
  }
}

}  // namespace repose
