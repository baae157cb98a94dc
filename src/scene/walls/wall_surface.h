#pragma once

#include <cstddef>
#include <vector>

#include "deck/deck.h"
#include "scene/walls/wall.h"

namespace repose {

/// A surface to look at: flat polygons, each by the places of its points, one after the other around it.
struct WallSurface {
  std::vector<Vec3> points;  ///< m
  std::vector<std::vector<std::size_t>> polygons;
};

/// The wall where its motions have brought it. A circle has 72 sides; a plane, which has no end, is cut at the sides of
/// the domain. The same bits everywhere.
WallSurface surface_of(const Wall& wall, const DomainDeck& domain);

}  // namespace repose
