#pragma once

#include <span>
#include <string>

#include "deck/deck.h"
#include "scene/walls/wall.h"

namespace repose {

/// The walls that are present, where they are, as PolyData of VTK (.vtp): polygons, each with the place of its wall in
/// the deck.
std::string walls_text(std::span<const Wall> walls, const DomainDeck& domain, double time_s);

}  // namespace repose
