#pragma once

#include <cmath>
#include <vector>

#include "deck/deck.h"
#include "scene/insertion/new_particles.h"
#include "target.h"

namespace repose::fuzz {

/// The materials that the inputs may name: glass and steel.
inline std::vector<MaterialDeck> two_materials() {
  std::vector<MaterialDeck> materials(2);
  materials[0].name = "glass";
  materials[1].name = "steel";
  return materials;
}

inline bool is_finite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// What holds of every list of particles that is accepted.
inline void check_particles(const NewParticles& all, std::size_t materials) {
  const std::size_t count = all.size();
  expect(count > 0, "there are particles");
  expect(all.velocity.size() == count && all.spin.size() == count, "each particle has its velocity and spin");
  expect(all.radius.size() == count && all.material.size() == count, "each particle has its radius and material");
  for (std::size_t i = 0; i < count; ++i) {
    expect(is_finite(all.position[i]) && is_finite(all.velocity[i]) && is_finite(all.spin[i]), "numbers are finite");
    expect(std::isfinite(all.radius[i]) && all.radius[i] > 0.0, "radii are finite and positive");
    expect(all.material[i] >= 0 && static_cast<std::size_t>(all.material[i]) < materials, "materials are known");
  }
}

}  // namespace repose::fuzz
