#include "scene/insertion/lattice.h"

#include <cmath>

#include <fmt/core.h>

#include "base/error.h"
#include "scene/insertion/fill.h"
#include "scene/insertion/region.h"

namespace repose {
namespace {

/// All three lattices lie on a simple cubic one of half the spacing.
bool is_site(LatticeType type, std::int64_t x, std::int64_t y, std::int64_t z) {
  switch (type) {
    case LatticeType::simple_cubic:
      return x % 2 == 0 && y % 2 == 0 && z % 2 == 0;
    case LatticeType::body_centred:
      return x % 2 == y % 2 && y % 2 == z % 2;
    case LatticeType::face_centred:
      return (x + y + z) % 2 == 0;
  }
  return false;
}

/// Half spacings: the first site and how many planes there are along each axis.
struct Planes {
  Vec3 first;
  std::int64_t x, y, z;
};

/// DeckError for more sites than a block may have, and before one of the numbers of planes would overflow.
void check_size(double x, double y, double z, const std::string& block) {
  const double sites = 0.125 * x * y * z;
  if (!(sites < most_particles)) throw too_many("sites", sites, block);
}

Planes planes_of(const ParticlesDeck& lattice, const std::string& block) {
  const auto& counts = lattice.counts;
  if (!counts.empty()) {
    const auto planes = [&](std::size_t k) { return 2.0 * static_cast<double>(counts[k]); };
    check_size(planes(0), planes(1), planes(2), block);
  }
  if (!counts.empty()) return {lattice.first, 2 * counts[0], 2 * counts[1], 2 * counts[2]};
  const auto [min, max] = bounds(lattice);
  const double step = lattice.lattice == LatticeType::simple_cubic ? lattice.spacing : 0.5 * lattice.spacing;
  const double per_half = 2.0 * step / lattice.spacing;  // planes that are not empty come every so many half spacings
  const auto steps = [&](double length) { return std::floor((length - lattice.diameter) / step + fit_rounding); };
  const Vec3 size = max - min;
  const Vec3 n = {steps(size.x), steps(size.y), steps(size.z)};
  check_size(1.0 + n.x * per_half, 1.0 + n.y * per_half, 1.0 + n.z * per_half, block);
  const auto planes = [&](double k) { return static_cast<std::int64_t>(k * per_half) + 1; };
  return {{0.5 * (min.x + max.x) - 0.5 * n.x * step, 0.5 * (min.y + max.y) - 0.5 * n.y * step,
           min.z + 0.5 * lattice.diameter},
          planes(n.x),
          planes(n.y),
          planes(n.z)};
}

}  // namespace

std::vector<Vec3> lattice_sites(const ParticlesDeck& lattice, const std::vector<Wall>& walls,
                                const std::string& block) {
  const Planes planes = planes_of(lattice, block);
  const double radius = 0.5 * lattice.diameter;
  std::vector<Vec3> sites;
  for (std::int64_t z = 0; z < planes.z; ++z) {
    for (std::int64_t y = 0; y < planes.y; ++y) {
      for (std::int64_t x = 0; x < planes.x; ++x) {
        if (!is_site(lattice.lattice, x, y, z)) continue;
        const Vec3 steps = {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
        const Vec3 site = planes.first + (0.5 * lattice.spacing) * steps;
        const bool fits = holds_sphere(lattice, site, radius) && clear_of_walls(site, radius, walls);
        if (!lattice.counts.empty() || fits) sites.push_back(site);
      }
    }
  }
  if (sites.empty()) throw DeckError(fmt::format("{}: no site of the lattice fits into the region", block));
  return sites;
}

}  // namespace repose
