#pragma once

#include "output/run_cost.h"
#include "simulation/simulation.h"

namespace repose {

/// Collective. What the time loop has cost so far: wall time by stage, lists, ghosts, memory, and how it was divided
/// among the ranks, of which this one has taken `cpu_seconds` of processor time.
LoopCost loop_cost(const Simulation& simulation, double cpu_seconds);

}  // namespace repose
