#pragma once

#include <span>
#include <string>

#include "measurement/scattering.h"

namespace repose {

/// A picture (the bytes of a PNG) of the plate from above for a person to look at: its edge, the grains in the colours
/// of their areas, the circles between the areas, a scale bar, the base's diameter and the counts. `deck` is that of
/// the measurement. y points up.
std::string top_view_png(const ScatteringDeck& deck, const Scattering& result, std::span<const Sphere> grains);

}  // namespace repose
