#pragma once

#include <span>
#include <string>

#include "measurement/scattering.h"
#include "pictures/canvas.h"

namespace repose {

/// The diameter of the base as it was measured, whatever the areas are counted from.
std::string base_text(const Scattering& result);

/// A picture of the plate from above for a person to look at: its edge, the grains in the colours
/// of their areas, the circles between the areas, a scale bar, the base's diameter and the counts. `deck` is that of
/// the measurement. y points up.
Picture top_view_picture(const ScatteringDeck& deck, const Scattering& result, std::span<const Sphere> grains);

}  // namespace repose
