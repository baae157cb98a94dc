#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/error.h"
#include "deck/deck.h"
#include "scene/walls/wall.h"

namespace repose {

/// A block of as many particles or more is refused before memory is asked for.
inline constexpr double most_particles = 1e9;

/// That so many `what` of a block are too many, and how many may be.
DeckError too_many(const char* what, double count, const std::string& block);

/// Number of particles a fill block asks for: its count, or its mass (kg) over the mass of one particle of the density
/// (kg/m^3), rounded. DeckError, beginning with `block`, when that is none or too many.
std::int64_t fill_count(const ParticlesDeck& fill, double density, const std::string& block);

/// Positions of `count` particles on a jittered simple cubic lattice in the region of a fill block, layer by layer from
/// the bottom. A site counts when its sphere stays in the region wherever the jitter moves it and when the moved sphere
/// does not reach into a present wall. The particle at index i of the result is number first_id + i and draws its
/// jitter from (seed, number). DeckError, beginning with `block`, that says how many fit and what would, when not all
/// do.
std::vector<Vec3> fill_region(const ParticlesDeck& fill, std::int64_t count, std::int64_t first_id, std::uint64_t seed,
                              const std::vector<Wall>& walls, const std::string& block);

}  // namespace repose
