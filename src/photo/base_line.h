#pragma once

#include <optional>

#include "photo/patches.h"
#include "photo/photo_deck.h"

namespace repose::photo {

/// The line on which a pile stands, seen from the side: y = y_at_0 + slope x, px, and how far the plate reaches where
/// the plate itself is seen.
struct BaseLine {
  double y_at_0 = 0.0;
  double slope = 0.0;
  std::optional<double> plate_left, plate_right;  ///< px

  double y(double x) const { return y_at_0 + slope * x; }
};

/// The base line of the patch `pile`, which holds the pile and may hold the plate. It holds the plate where the line
/// that most tops of its columns lie on, level but for four degrees, has more beneath it than a seventh of the pile's
/// height, and thus more than a layer of grains; the plate's edge is that line, or lies below it by a layer of grains
/// that is found by its uneven brightness in `excess`. Otherwise the plate looks like the background, and the line goes
/// through the pile's feet, which a camera that looks down sees in the plane of the axis.
BaseLine find_base_line(const Image& excess, const Patches& patches, std::int32_t pile);

}  // namespace repose::photo
