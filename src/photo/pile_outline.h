#pragma once

#include "measurement/angle_of_repose.h"
#include "photo/level.h"
#include "photo/patches.h"

namespace repose::photo {

/// What stands out above the base line at a threshold: the pile is its largest patch, if there is one.
struct Extent {
  Patches patches;
  Largest found;

  const Patch& pile() const { return patches.all[static_cast<std::size_t>(found.first)]; }
};

/// Of a levelled picture.
Extent extent_of(const Level& level, double threshold);

/// The median of the excess over the pile.
double contrast_of_pile(const Level& level, const Extent& extent);

/// The outline in px: rows from the base line upwards, u from the left edge of the picture.
Silhouette outline_of(const Level& level, const Extent& extent, double threshold);

/// The width of the edge along the rows from 25 to 75 % of the contrast, as that from 10 to 90 % of an edge that is
/// blurred as by a lens out of focus (normally distributed: 1.9 times as wide). That which a fifth of the rows have at
/// most: grains that fade into their shadow have wide edges in focus, too.
double blur_of(const Level& level, const Silhouette& outline, double contrast);

/// Root mean square of the outline's distance from its lines, across them, between the fitted heights, in its own unit.
double roughness(const Silhouette& outline, const FlankView& fit);

}  // namespace repose::photo
