#pragma once

#include <string>

#include "comm/communicator.h"
#include "run/run_file.h"

namespace repose {

/// Collective. Does the runs of the sensitivity deck `request.deck`: each parameter at its lower and its upper value
/// with the others as in the base deck (thesis section 3.3.3), and Morris's walks when the deck has them. Writes
/// sensitivity.json, grid.h5 and grid.csv to the directory; returns the tables for a person, on rank 0. As
/// calibrate_file otherwise.
std::string sensitivity_file(const Communicator& world, const RunRequest& request, const StopAsked& stop_asked);

/// Collective. What it would run, as check_calibration says it.
std::string check_sensitivity(const Communicator& world, const RunRequest& request);

}  // namespace repose
