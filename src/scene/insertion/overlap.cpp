#include "scene/insertion/overlap.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "scene/insertion/sphere_grid.h"

namespace repose {

void for_each_overlap(std::span<const Vec3> position, std::span<const double> radius,
                      const std::function<void(std::size_t, std::size_t)>& found) {
  // From large to small, so that each sphere meets those of its own size and larger ones, in cells that are no smaller.
  std::vector<std::size_t> order(radius.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return radius[a] > radius[b]; });
  SphereGrid grid;
  for (const std::size_t i : order) {
    grid.any_near(position[i], radius[i], [&](const SphereGrid::Sphere& other) {
      const double sum = radius[i] + other.radius;
      if (squared_norm(position[i] - other.position) < sum * sum) {
        found(std::max(i, other.index), std::min(i, other.index));
      }
      return false;  // go on
    });
    grid.add(position[i], radius[i], i);
  }
}

}  // namespace repose
