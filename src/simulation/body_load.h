#pragma once

#include <string>
#include <vector>

#include "measurement/wall_loads.h"
#include "simulation/simulation.h"

namespace repose {

/// Whether a wall has one of these names, or moves with one that has.
bool is_of(const std::vector<Wall>& walls, std::size_t wall, const std::vector<std::string>& names);

/// Collective. What the grains do to the walls of these names, and to those that move with them, together.
WallLoad load_on(const Simulation& simulation, const std::vector<std::string>& names);

}  // namespace repose
