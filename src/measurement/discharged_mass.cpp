#include "measurement/discharged_mass.h"

#include <limits>

#include "scene/particles/sphere_mass.h"

namespace repose {
namespace {

constexpr std::size_t top_exit = 5;  // z_max in exit_names

/// Mass of this rank's particles below `height`, in units.
std::int64_t mass_below(double height, const MaterialTable& materials, const MassUnit& unit,
                        const Particles& particles) {
  std::int64_t mass = 0;
  for (std::size_t i = 0; i < particles.owned; ++i) {
    const ParticleRecord& p = particles.record[i];
    if (is_parked(p) || particles.position(i).z >= height) continue;
    mass += unit.count(sphere_mass(p.radius, materials[static_cast<std::size_t>(particles.material[i])].density));
  }
  return mass;
}

/// Mass that has left this rank by any exit but the top, in units.
std::int64_t left_below(const ExitCount& left_here) {
  std::int64_t mass = 0;
  for (std::size_t e = 0; e < left_here.mass.size(); ++e) mass += e == top_exit ? 0 : left_here.mass[e];
  return mass;
}

}  // namespace

double discharged_mass(const Communicator& comm, double orifice_height, const MaterialTable& materials,
                       const MassUnit& unit, const Particles& particles, const ExitCount& left_here) {
  const std::int64_t mass = mass_below(orifice_height, materials, unit, particles);
  return unit.kilograms(comm.sum(mass + left_below(left_here)));
}

double total_mass(const Communicator& comm, const MaterialTable& materials, const MassUnit& unit,
                  const Particles& particles, const ExitCount& left_here) {
  const std::int64_t mass = mass_below(std::numeric_limits<double>::infinity(), materials, unit, particles);
  return unit.kilograms(comm.sum(mass + left_below(left_here)));
}

}  // namespace repose
