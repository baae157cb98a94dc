#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "deck/deck.h"
#include "scene/sizes/size_distribution.h"

namespace repose {

/// Radii (m) of the particles of a block, drawn from a distribution by (seed, number): `count` of them, or as many as
/// bring the mass (kg, at a density in kg/m^3) to the wanted one within half of the last. The particle at index i is
/// number first_id + i. DeckError, beginning with `block`, when that is none or more than can be.
std::vector<double> draw_radii(const ParticlesDeck& particles, const SizeDistribution& sizes, double density,
                               std::int64_t first_id, std::uint64_t seed, const std::string& block);

}  // namespace repose
