#pragma once

#include <span>

#include "measurement/angle_of_repose.h"
#include "pictures/canvas.h"

namespace repose {

/// A picture of the first view for a person to look at: the grains of the pile, the silhouette,
/// the fitted lines with the heights they were fitted between, the plate, a scale bar and the angles. `parameters` are
/// those of the measurement.
Picture silhouette_picture(const AngleOfRepose& result, std::span<const Sphere> pile,
                           const AngleOfReposeParameters& parameters);

}  // namespace repose
