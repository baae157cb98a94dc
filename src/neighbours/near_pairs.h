#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/particles.h"

namespace repose {

/// All pairs of particles that are closer than the sum of their reaches (m, one entry per particle), as indices, the
/// smaller one first and ascending; those of two particles from `owned` on are left out. The cost grows linearly with
/// the number of particles, whatever their sizes and the size of the domain.
std::vector<std::array<std::int32_t, 2>> near_pairs(std::span<const ParticleRecord> particles,
                                                    std::span<const double> reach, std::size_t owned);

}  // namespace repose
