#include "scene/insertion/grain_sizes.h"

#include <fmt/core.h>

#include "base/error.h"
#include "base/philox.h"
#include "scene/insertion/fill.h"
#include "scene/particles/sphere_mass.h"

namespace repose {

std::vector<double> draw_radii(const ParticlesDeck& particles, const SizeDistribution& sizes, double density,
                               std::int64_t first_id, std::uint64_t seed, const std::string& block) {
  if (!particles.sizes.enabled) {
    return std::vector<double>(static_cast<std::size_t>(fill_count(particles, density, block)),
                               0.5 * particles.diameter);
  }
  const double expected =
      particles.count > 0 ? static_cast<double>(particles.count) : particles.mass / (density * sizes.mean_volume());
  if (!(expected < most_particles)) throw too_many("particles", expected, block);
  std::vector<double> radii;
  const auto next = [&] {
    const auto id = static_cast<std::uint64_t>(first_id) + radii.size();
    return 0.5 * sizes.quantile(uniform(seed, id, RandomStream::particle_size, 0));
  };
  while (static_cast<std::int64_t>(radii.size()) < particles.count) radii.push_back(next());
  if (particles.count > 0) return radii;
  for (double mass = 0.0; mass < particles.mass;) {
    const double radius = next();
    const double more = sphere_mass(radius, density);
    if (mass + 0.5 * more > particles.mass) break;
    mass += more;
    radii.push_back(radius);
  }
  if (radii.empty()) throw DeckError(fmt::format("{}: count or mass must give at least one particle", block));
  return radii;
}

}  // namespace repose
