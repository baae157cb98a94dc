#include "domain/exits.h"

#include <algorithm>

#include "scene/particles/periodicity.h"
#include "scene/particles/sphere_mass.h"

namespace repose {
namespace {

/// Whether a position beyond the face of an exit is beside the part of it that the exit takes.
bool takes(const ExitDeck& exit, const Vec3& x) {
  const auto within = [](double value, double min, double max) { return !(value < min) && !(value >= max); };
  const auto across = static_cast<Axis>(static_cast<int>(exit.face) / 2);
  return (across == Axis::x || within(x.x, exit.min.x, exit.max.x)) &&
         (across == Axis::y || within(x.y, exit.min.y, exit.max.y)) &&
         (across == Axis::z || within(x.z, exit.min.z, exit.max.z));
}

}  // namespace

ExitCount sum_of(const Communicator& comm, const ExitCount& left_here) {
  ExitCount all = left_here;
  comm.sum_elements(std::span(all.particles.begin(), all.particles.end()));
  comm.sum_elements(std::span(all.mass.begin(), all.mass.end()));
  comm.sum_elements(std::span(all.named_particles.begin(), all.named_particles.end()));
  comm.sum_elements(std::span(all.named_mass.begin(), all.named_mass.end()));
  return all;
}

std::vector<ExitTotal> exit_totals(std::span<const ExitDeck> exits, const ExitCount& left) {
  std::vector<ExitTotal> totals;
  for (std::size_t f = 0; f < exit_names.size(); ++f)
    totals.push_back({exit_names[f], left.particles[f], left.mass[f]});
  for (std::size_t e = 0; e < exits.size(); ++e) {
    totals.push_back({exits[e].name, left.named_particles[e], left.named_mass[e]});
    ExitTotal& face = totals[static_cast<std::size_t>(exits[e].face)];
    face.particles -= left.named_particles[e];
    face.mass -= left.named_mass[e];
  }
  return totals;
}

void retire_leavers(const DomainDeck& domain, std::span<const ExitDeck> exits, const MaterialTable& materials,
                    const MassUnit& unit, Particles& particles, ExitCount& left) {
  const Vec3 low = domain.min;
  const Vec3 high = domain.max;
  left.named_particles.resize(exits.size());
  left.named_mass.resize(exits.size());
  for (std::size_t i = 0; i < particles.owned; ++i) {
    ParticleRecord& p = particles.record[i];
    const Vec3 x = particles.position(i);
    if (!is_outside(domain, x) || is_parked(p)) continue;
    const std::array<double, 6> beyond = {low.x - x.x,  x.x - high.x, low.y - x.y,
                                          x.y - high.y, low.z - x.z,  x.z - high.z};
    const auto face = static_cast<std::size_t>(std::max_element(beyond.begin(), beyond.end()) - beyond.begin());
    const Material& material = materials[static_cast<std::size_t>(particles.material[i])];
    const std::int64_t mass = unit.count(sphere_mass(p.radius, material.density));
    ++left.particles[face];
    left.mass[face] += mass;
    const auto named = std::find_if(exits.begin(), exits.end(), [&](const ExitDeck& exit) {
      return static_cast<std::size_t>(exit.face) == face && takes(exit, x);
    });
    if (named != exits.end()) {
      const auto e = static_cast<std::size_t>(named - exits.begin());
      ++left.named_particles[e];
      left.named_mass[e] += mass;
    }
    park(p, particles.id[i]);
  }
}

}  // namespace repose
