#pragma once

#include <optional>

#include "measurement/tilt_onset.h"
#include "output/summary.h"
#include "simulation/simulation.h"

namespace repose {

/// Collective. Takes a sample while the apparatus tilts.
void sample_tilt_onset(const Simulation& simulation, TiltOnset& onset);

/// Collective. The figures of an inclined plane in the summary, none before the onset: the one found in this run and,
/// if the deck asks for it, at half the rate of tilt (by another run, which writes nothing) and extrapolated to a rate
/// of zero; its excess over the angle whose tangent is the coefficient of friction that held the particle: of rolling
/// friction, or of sliding friction when its rotation is blocked.
void summarise_tilt_onset(const Simulation& simulation, const ReadFile& read_file, const TiltOnset& watch,
                          Summary& summary);

}  // namespace repose
