#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "scene/particles/particles.h"

namespace repose {

/// Indices of the particles in the order of layers, one mean diameter thick, across the longest side of their bounding
/// box, and of rows within a layer; ties are broken by id. Whoever takes the pairs in the order of their later particle
/// then meets new particles one after the other, as processors fetch them ahead by themselves, and the earlier ones
/// while their layer is still in the second-level cache; layers too large for that are cut into strips.
std::vector<std::size_t> layer_order(std::span<const ParticleRecord> particles, std::span<const std::int64_t> ids);

}  // namespace repose
