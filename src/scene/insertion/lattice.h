#pragma once

#include <string>
#include <vector>

#include "deck/deck.h"
#include "scene/walls/wall.h"

namespace repose {

/// Sites (m) of the regular lattice of a block, layer by layer from below. With counts: so many cubic cells from the
/// first site on. With a region: every site whose sphere lies in it and reaches into no present wall; the lattice
/// begins at the region's bottom and is centred across. DeckError, beginning with `block`, when there is none.
std::vector<Vec3> lattice_sites(const ParticlesDeck& lattice, const std::vector<Wall>& walls, const std::string& block);

}  // namespace repose
