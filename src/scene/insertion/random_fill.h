#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "deck/deck.h"
#include "scene/walls/wall.h"

namespace repose {

/// Positions of spheres of many sizes, spread evenly over the region of a fill block: random sequential placement, from
/// the largest to the smallest, each at the first of its random places where it meets neither another one nor a present
/// wall. The sphere at index i has radii[i] (m) and is number first_id + i, by which its places are drawn. About 28 %
/// of a wide region's volume can be filled when all are alike, more when the sizes differ widely. DeckError, beginning
/// with `block`, that says how many fit and what would help, when not all do.
std::vector<Vec3> random_fill(const ParticlesDeck& fill, std::span<const double> radii, std::int64_t first_id,
                              std::uint64_t seed, const std::vector<Wall>& walls, const std::string& block);

}  // namespace repose
