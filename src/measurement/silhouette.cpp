#include "measurement/silhouette.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace repose {

std::vector<Disc> project(std::span<const Sphere> grains, const View& view) {
  const double c = std::cos(view.azimuth);
  const double s = std::sin(view.azimuth);
  std::vector<Disc> discs;
  discs.reserve(grains.size());
  for (const Sphere& grain : grains) {
    const Vec3 p = grain.centre - view.axis;
    const double nearness = s * p.x - c * p.y;
    if (nearness + grain.radius >= view.camera_distance) {
      throw DeckError(
          "measurement.angle_of_repose.camera_distance: the camera stands in the pile; it must be greater "
          "than the radius of the pile");
    }
    const double scale = 1.0 / (1.0 - nearness / view.camera_distance);
    discs.push_back({.u = scale * (c * p.x + s * p.y),
                     .z = view.camera_height + scale * (grain.centre.z - view.camera_height),
                     .radius = scale * grain.radius,
                     .nearness = nearness});
  }
  return discs;
}

Silhouette silhouette(std::span<const Disc> discs, double base, double row_height) {
  Silhouette result{.base = base, .row_height = row_height, .top = base, .left = {}, .right = {}};
  for (const Disc& disc : discs) result.top = std::max(result.top, disc.z + disc.radius);
  const auto rows = static_cast<std::size_t>(std::ceil((result.top - base) / row_height));
  constexpr double infinity = std::numeric_limits<double>::infinity();
  result.left.assign(rows, infinity);
  result.right.assign(rows, -infinity);

  for (const Disc& disc : discs) {
    const double first = std::max(0.0, std::ceil((disc.z - disc.radius - base) / row_height - 0.5));
    if (disc.z + disc.radius < base) continue;
    for (auto row = static_cast<std::size_t>(first); row < rows; ++row) {
      const double dz = result.row_z(row) - disc.z;
      if (dz > disc.radius) break;
      const double half = std::sqrt(std::max(0.0, disc.radius * disc.radius - dz * dz));
      result.left[row] = std::min(result.left[row], disc.u - half);
      result.right[row] = std::max(result.right[row], disc.u + half);
    }
  }
  for (std::size_t row = 0; row < rows; ++row) {
    if (result.left[row] > result.right[row]) {
      result.left[row] = result.right[row] = std::numeric_limits<double>::quiet_NaN();
    }
  }
  return result;
}

}  // namespace repose
