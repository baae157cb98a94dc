#pragma once

#include <span>
#include <string>

#include "measurement/angle_of_repose.h"

namespace repose {

/// A picture (the bytes of a PNG) of the first view for a person to look at: the grains of the pile, the silhouette,
/// the fitted lines with the heights they were fitted between, the plate, a scale bar and the angles. `parameters` are
/// those of the measurement.
std::string silhouette_png(const AngleOfRepose& result, std::span<const Sphere> pile,
                           const AngleOfReposeParameters& parameters);

}  // namespace repose
