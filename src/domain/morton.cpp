#include "domain/morton.h"

#include <algorithm>
#include <tuple>

namespace repose {
namespace {

/// Spreads the low 21 bits of `v` so that two zero bits follow each.
std::uint64_t spread(std::uint64_t v) {
  v &= 0x1fffff;
  v = (v | v << 32) & 0x001f00000000ffffULL;
  v = (v | v << 16) & 0x001f0000ff0000ffULL;
  v = (v | v << 8) & 0x100f00f00f00f00fULL;
  v = (v | v << 4) & 0x10c30c30c30c30c3ULL;
  return (v | v << 2) & 0x1249249249249249ULL;
}

}  // namespace

std::vector<std::size_t> morton_order(std::span<const ParticleRecord> particles, std::span<const std::int64_t> ids) {
  std::vector<std::size_t> order(particles.size());
  if (particles.empty()) return order;
  Vec3 low = particles[0].position;
  Vec3 high = low;
  for (const ParticleRecord& p : particles) {
    low = {std::min(low.x, p.position.x), std::min(low.y, p.position.y), std::min(low.z, p.position.z)};
    high = {std::max(high.x, p.position.x), std::max(high.y, p.position.y), std::max(high.z, p.position.z)};
  }
  const double longest = std::max({high.x - low.x, high.y - low.y, high.z - low.z, 1e-300});
  const double steps = static_cast<double>((1 << 21) - 1) / longest;

  std::vector<std::tuple<std::uint64_t, std::int64_t, std::size_t>> keys(particles.size());
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const Vec3 at = steps * (particles[i].position - low);
    keys[i] = {spread(static_cast<std::uint64_t>(at.x)) | spread(static_cast<std::uint64_t>(at.y)) << 1 |
                   spread(static_cast<std::uint64_t>(at.z)) << 2,
               ids[i], i};
  }
  std::sort(keys.begin(), keys.end());
  for (std::size_t k = 0; k < keys.size(); ++k) order[k] = std::get<2>(keys[k]);
  return order;
}

}  // namespace repose
