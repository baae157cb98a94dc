#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "scene/particles/particles.h"

namespace repose {

/// Indices of the particles in the order of a Morton (Z) curve over their bounding box: neighbours in space become
/// neighbours in memory. Ties are broken by id.
std::vector<std::size_t> morton_order(std::span<const ParticleRecord> particles, std::span<const std::int64_t> ids);

}  // namespace repose
