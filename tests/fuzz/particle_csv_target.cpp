// A list of particles.
#include "particle_promises.h"
#include "scene/insertion/particle_csv.h"

namespace repose::fuzz {

bool accepts(std::string_view input) {
  NewParticles particles;
  const auto materials = two_materials();
  if (!is_done([&] { particles = parse_particle_csv(input, "grains.csv", materials); })) return false;
  check_particles(particles, materials.size());
  return true;
}

}  // namespace repose::fuzz
