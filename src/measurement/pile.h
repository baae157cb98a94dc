#pragma once

#include <span>
#include <vector>

#include "measurement/sphere.h"

namespace repose {

inline constexpr double default_contact_gap = 0.05;  ///< of the smaller diameter

/// The grains of the pile on the plate, in the order given: the cluster of touching grains (clusters.h) with the
/// greatest volume of all clusters that rest on the plate and are a pile. Grains with their centre above `max_height`
/// or below `plate_height` (m) are left out beforehand. Grains in the air and strays on the plate touch no pile and so
/// belong to none. A cluster is a pile when it reaches three of its mean diameters above the plate and has 20 grains:
/// less is a layer of grains without flanks. Empty when there is none.
std::vector<Sphere> find_pile(std::span<const Sphere> grains, double plate_height, double max_height,
                              double gap = default_contact_gap);

}  // namespace repose
