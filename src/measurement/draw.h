#pragma once

#include <span>
#include <string>

#include "measurement/angle_of_repose.h"

namespace repose {

/// A picture of the first view for a person to look at: the grains of the pile, the silhouette, the fitted lines with
/// the heights they were fitted between, the plate, a scale bar and the angles. `parameters` are those of the
/// measurement. The PNG appears whole or not at all; FileError names `path` when it cannot be written.
void write_silhouette_png(const std::string& path, const AngleOfRepose& result, std::span<const Sphere> pile,
                          const AngleOfReposeParameters& parameters);

}  // namespace repose
