#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "base/vec3.h"

namespace repose {

/// Spheres in hashed cells, one set of cells per power of two of the radius: what is near a sphere is found in constant
/// time also when the sizes differ widely.
class SphereGrid {
 public:
  struct Sphere {
    Vec3 position;  ///< m
    double radius;  ///< m
    std::size_t index;
  };

  void add(const Vec3& position, double radius, std::size_t index = 0);

  /// Whether holds(sphere) for any of the spheres that may be nearer to the given one than the sum of both radii; asks
  /// some others around as well, and none after the first that holds. The order depends on the spheres and the order of
  /// their addition alone.
  template <class Predicate>
  bool any_near(const Vec3& position, double radius, Predicate&& holds) const {
    for (const Level& level : levels_) {
      const double reach = radius + 0.5 * level.cell_size;
      const Cell low = level.cell_of(position - Vec3{reach, reach, reach});
      const Cell high = level.cell_of(position + Vec3{reach, reach, reach});
      for (std::int64_t x = low.x; x <= high.x; ++x) {
        for (std::int64_t y = low.y; y <= high.y; ++y) {
          for (std::int64_t z = low.z; z <= high.z; ++z) {
            const auto cell = level.cells.find({x, y, z});
            if (cell == level.cells.end()) continue;
            if (std::any_of(cell->second.begin(), cell->second.end(), holds)) return true;
          }
        }
      }
    }
    return false;
  }

  /// Whether any sphere is nearer than the sum of both radii.
  bool overlaps(const Vec3& position, double radius) const {
    return any_near(position, radius, [&](const Sphere& other) {
      const double sum = radius + other.radius;
      return squared_norm(position - other.position) < sum * sum;
    });
  }

 private:
  struct Cell {
    std::int64_t x, y, z;
    bool operator==(const Cell&) const = default;
  };
  struct CellHash {
    std::size_t operator()(const Cell& cell) const;
  };
  /// Spheres with radius in [2^(exponent-1), 2^exponent) in cells of twice their greatest radius.
  struct Level {
    int exponent;
    double cell_size;
    std::unordered_map<Cell, std::vector<Sphere>, CellHash> cells;

    Cell cell_of(const Vec3& position) const;
  };

  std::vector<Level> levels_;
};

}  // namespace repose
