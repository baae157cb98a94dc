#include "domain/layer_order.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

namespace repose {
namespace {

constexpr std::size_t layer_particles = 2000;  // whose records and sums take a third of a second-level cache of 1 MiB
constexpr std::uint64_t last_cell = (1U << 18) - 1;  // three of them and a strip fit one 64-bit number
constexpr double most_strips = 1U << 10;

using Coordinates = std::array<double, 3>;

Coordinates coordinates(const Vec3& v) { return {v.x, v.y, v.z}; }

/// The cells of a bounding box.
class Layers {
 public:
  explicit Layers(std::span<const ParticleRecord> particles) {
    Coordinates high;
    high.fill(-std::numeric_limits<double>::infinity());
    low_.fill(std::numeric_limits<double>::infinity());
    double radii = 0.0;
    for (const ParticleRecord& p : particles) {
      const Coordinates at = coordinates(p.position);
      for (std::size_t k = 0; k < 3; ++k) {
        low_[k] = std::min(low_[k], at[k]);
        high[k] = std::max(high[k], at[k]);
      }
      radii += p.radius;
    }
    const auto length = [&](std::size_t axis) { return high[axis] - low_[axis]; };
    std::stable_sort(axes_.begin(), axes_.end(), [&](std::size_t a, std::size_t b) { return length(a) > length(b); });
    const double longest = length(axes_[0]);
    const auto count = static_cast<double>(particles.size());
    width_ = std::max({2.0 * radii / count, longest / static_cast<double>(last_cell), 1e-300});
    const double layers = std::floor(longest / width_) + 1.0;
    const double strips = std::min(std::ceil(count / (layers * static_cast<double>(layer_particles))), most_strips);
    strip_ = std::max(width_, (length(axes_[1]) + width_) / strips);
  }

  std::uint64_t key(const Vec3& position) const {
    const Coordinates at = coordinates(position);
    std::uint64_t key = cell(at, axes_[1], strip_);
    for (const std::size_t axis : axes_) key = key << 18 | cell(at, axis, width_);
    return key;
  }

 private:
  std::uint64_t cell(const Coordinates& at, std::size_t axis, double width) const {
    return std::min(static_cast<std::uint64_t>((at[axis] - low_[axis]) / width), last_cell);
  }

  Coordinates low_;
  std::array<std::size_t, 3> axes_ = {0, 1, 2};  ///< the longest first
  double width_ = 0.0;                           ///< m, of a layer and a row
  double strip_ = 0.0;                           ///< m
};

}  // namespace

std::vector<std::size_t> layer_order(std::span<const ParticleRecord> particles, std::span<const std::int64_t> ids) {
  std::vector<std::size_t> order(particles.size());
  if (particles.empty()) return order;
  const Layers layers(particles);
  std::vector<std::tuple<std::uint64_t, std::int64_t, std::size_t>> keys(particles.size());
  for (std::size_t i = 0; i < particles.size(); ++i) keys[i] = {layers.key(particles[i].position), ids[i], i};
  std::sort(keys.begin(), keys.end());
  for (std::size_t k = 0; k < keys.size(); ++k) order[k] = std::get<2>(keys[k]);
  return order;
}

}  // namespace repose
