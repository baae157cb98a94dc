#pragma once

#include "import/imported_scene.h"

namespace repose {

/// A region that grains are inserted into, as a deck says it.
struct DeckRegion {
  bool is_box = true;
  Extent box = {};  ///< of a cylinder that around it
  Vec3 centre = {};
  double radius = 0.0;
  double height = 0.0;

  double volume() const;
  /// How far a grain moves along a direction until it has surely left.
  double length_along(const Vec3& way) const;
  double smallest_size() const;
};

/// Within the domain. DeckError at the region's line when a deck has no such region.
DeckRegion deck_region(const ScriptRegion& region, const Extent& domain);

bool are_same(const DeckRegion& a, const DeckRegion& b);
/// Whether the boxes around them overlap.
bool overlap(const DeckRegion& a, const DeckRegion& b);

/// Whether a wall that is a primitive lies in the region, or bounds it within `gap` (m), where grains go along `way`.
bool is_held(const DeckRegion& region, const Vec3& way, double gap, const ScriptWall& wall);

/// Whether `grown` knows where this wall ends the region: planes do so, and cylinders about its axis.
bool can_bound(const DeckRegion& region, const ScriptWall& wall);
/// The region larger by `by` (m) on all sides, but not across the domain or walls that can bound it.
DeckRegion grown(const DeckRegion& region, double by, const Extent& domain,
                 const std::vector<const ScriptWall*>& walls);

}  // namespace repose
