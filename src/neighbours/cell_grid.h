#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/particles.h"

namespace repose {

/// Particles sorted into cubic cells. Only occupied cells take memory (a hash table finds them), so that a large empty
/// domain costs nothing.
class CellGrid {
 public:
  CellGrid(std::span<const ParticleRecord> particles, double cell_size);

  /// Calls visit(index) for every particle in the cells that a cube of half-width `radius` about `centre` touches.
  template <class Visit>
  void for_each_near(const Vec3& centre, double radius, Visit&& visit) const {
    const Cell low = cell_of(centre - Vec3{radius, radius, radius});
    const Cell high = cell_of(centre + Vec3{radius, radius, radius});
    for (std::int64_t x = low.x; x <= high.x; ++x) {
      for (std::int64_t y = low.y; y <= high.y; ++y) {
        for (std::int64_t z = low.z; z <= high.z; ++z) {
          const std::int32_t run = find({x, y, z});
          if (run < 0) continue;
          for (std::int32_t k = begin_[static_cast<std::size_t>(run)]; k < begin_[static_cast<std::size_t>(run) + 1];
               ++k) {
            visit(static_cast<std::size_t>(sorted_[static_cast<std::size_t>(k)]));
          }
        }
      }
    }
  }

 private:
  struct Cell {
    std::int64_t x, y, z;
  };
  Cell cell_of(const Vec3& p) const {
    return {coordinate(p.x - origin_.x), coordinate(p.y - origin_.y), coordinate(p.z - origin_.z)};
  }
  std::int64_t coordinate(double offset) const;
  static std::uint64_t key(const Cell& c);
  std::int32_t find(const Cell& cell) const;

  Vec3 origin_;
  double inverse_size_;
  std::vector<std::int32_t> sorted_;  ///< particle indices, cell by cell
  std::vector<std::int32_t> begin_;   ///< start of each occupied cell's run in sorted_, and the end
  std::vector<std::uint64_t> keys_;   ///< of each occupied cell
  std::vector<std::int32_t> table_;   ///< hash slot to occupied cell, -1 when free
  std::uint64_t mask_ = 0;
};

}  // namespace repose
