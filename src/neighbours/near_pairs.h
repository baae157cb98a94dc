#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "neighbours/cell_levels.h"
#include "scene/particles/particles.h"

namespace repose {

/// Indices of two particles, the smaller one first.
using IndexPair = std::array<std::int32_t, 2>;

/// All pairs of particles that are closer than the sum of their reaches (m, one entry per particle), in the order
/// of the second; those of two particles from `owned` on are left out. The cost grows linearly with
/// the number of particles, whatever their sizes and the size of the domain.
std::vector<IndexPair> near_pairs(std::span<const ParticleRecord> particles, std::span<const double> reach,
                                  std::size_t owned);
/// The same, of particles that are sorted into levels by these reaches.
std::vector<IndexPair> near_pairs(std::span<const CellLevel> levels, std::span<const ParticleRecord> particles,
                                  std::span<const double> reach, std::size_t owned);

/// Which of the particles from `owned` to `total` are in any of the pairs.
std::vector<bool> ghosts_in(std::span<const IndexPair> pairs, std::size_t owned, std::size_t total);

/// The pairs after all ghosts but the `needed` ones were dropped.
void drop_ghosts(const std::vector<bool>& needed, std::size_t owned, std::span<IndexPair> pairs);

}  // namespace repose
