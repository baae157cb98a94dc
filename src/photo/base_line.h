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

/// The base line of the patch `pile`, which holds the pile and may hold the plate. Where at least a seventh of its
/// columns end at the top along one line, level but for four degrees, that is the plate's edge: fitted to those within
/// 1.5 px of it. Otherwise the plate looks like the background, and the line goes through the pile's feet, which a
/// camera that looks down sees in the plane of the axis.
BaseLine find_base_line(const Patches& patches, std::int32_t pile);

}  // namespace repose::photo
