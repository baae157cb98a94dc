#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "deck/deck.h"
#include "scene/insertion/new_particles.h"

namespace repose {

/// Particles from CSV text whose first line is `x,y,z,vx,vy,vz,wx,wy,wz,radius,material` or, for particles at rest,
/// `x,y,z,radius,material`: m, m/s, rad/s, the material by name. Blank lines and lines that begin with # are skipped.
/// DeckError as `file:line: what` on the first bad line.
NewParticles parse_particle_csv(std::string_view text, const std::string& file,
                                const std::vector<MaterialDeck>& materials);

/// The same for particles that are only measured: `x,y,z,radius` is enough, then `material` of the result is empty.
NewParticles parse_measured_csv(std::string_view text, const std::string& file,
                                const std::vector<MaterialDeck>& materials);

}  // namespace repose
