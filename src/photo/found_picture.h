#pragma once

#include "photo/pile_view.h"
#include "photo/plate_view.h"
#include "pictures/canvas.h"

namespace repose::photo {

/// The photograph with the outline, the base line and the fitted flanks.
Picture found_pile_picture(const Image& image, const PileView& view);

/// The photograph with the grains that were found, single ones, clumps and the pile in colours of their own, the base
/// and the areas.
Picture found_plate_picture(const Image& image, const PlateView& view);

}  // namespace repose::photo
