#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "measurement/sphere.h"

namespace repose {

/// The cluster of each grain: grains connected through touching pairs carry the same number, 0, 1, ... in the order of
/// their first grain. Two grains touch when the distance of their surfaces is at most `gap` times the smaller diameter
/// (gap >= 0). Time grows linearly with the grains, whatever their sizes. Positions are finite, radii positive.
std::vector<std::size_t> touching_clusters(std::span<const Sphere> grains, double gap);

}  // namespace repose
