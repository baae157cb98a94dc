#pragma once

#include <string>

#include "photo/pile_view.h"
#include "photo/plate_view.h"
#include "pictures/canvas.h"

namespace repose::photo {

/// The photograph with the outline, the base line and the fitted flanks.
Picture found_pile_picture(const Image& image, const PileView& view);

/// Its title: the base as it was measured, whatever the areas are counted from, and the counts.
std::string found_plate_title(const PlateView& view);

/// The photograph with the grains that were found, single ones, clumps and the pile in colours of their own, and
/// the circles that the areas begin at.
Picture found_plate_picture(const Image& image, const PlateView& view);

}  // namespace repose::photo
