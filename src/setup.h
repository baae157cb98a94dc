#pragma once

#include <vector>

#include "deck/deck.h"
#include "integration/time_step.h"
#include "scene/insertion.h"
#include "scene/materials.h"
#include "scene/wall.h"

/// Pieces of the set-up that a run and `repose check` share.
namespace repose {

std::vector<Wall> make_walls(const Deck& deck, const MaterialTable& materials, const ReadFile& read_file);

SmallestRadii smallest_radii(const NewParticles& particles, std::size_t materials);

}  // namespace repose
