#pragma once

#include "output/summary.h"
#include "simulation.h"

namespace repose {

/// Collective. What the time loop has cost so far, in the summary: wall time by stage, lists, ghosts, memory.
void summarise_cost(const Simulation& simulation, Summary& summary);

}  // namespace repose
