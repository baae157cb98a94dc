#include "domain/exits.h"

#include <algorithm>

#include "scene/sphere.h"

namespace repose {

void retire_leavers(const DomainDeck& domain, const MaterialTable& materials, const MassUnit& unit,
                    Particles& particles, ExitCount& left) {
  const Vec3 low = domain.min;
  const Vec3 high = domain.max;
  for (std::size_t i = 0; i < particles.owned; ++i) {
    ParticleRecord& p = particles.record[i];
    const Vec3 x = p.position;
    const bool inside = x.x >= low.x && x.x < high.x && x.y >= low.y && x.y < high.y && x.z >= low.z && x.z < high.z;
    if (inside || is_parked(p)) continue;
    const std::array<double, 6> beyond = {low.x - x.x,  x.x - high.x, low.y - x.y,
                                          x.y - high.y, low.z - x.z,  x.z - high.z};
    const auto exit = static_cast<std::size_t>(std::max_element(beyond.begin(), beyond.end()) - beyond.begin());
    const Material& material = materials[static_cast<std::size_t>(particles.material[i])];
    ++left.particles[exit];
    left.mass[exit] += unit.count(sphere_mass(p.radius, material.density));
    park(p, particles.id[i]);
  }
}

}  // namespace repose
