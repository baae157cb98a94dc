#pragma once

#include "output/summary.h"
#include "simulation/simulation.h"

namespace repose {

/// Collective. What the time loop has cost so far, in the summary: wall time by stage, lists, ghosts, memory, and how
/// it was divided among the ranks, of which this one has taken `cpu_seconds` of processor time.
void summarise_cost(const Simulation& simulation, double cpu_seconds, Summary& summary);

}  // namespace repose
