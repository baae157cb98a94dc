#pragma once

#include <string>

#include "comm/communicator.h"
#include "run/run_file.h"

namespace repose {

/// Collective. Does the runs of the calibration deck `request.deck` and estimates its parameters, in the directory
/// `request.output`: runs/NAME, grid.h5, grid.csv, calibration.toml, estimate.json. What is complete there is not done
/// again. Overrides are of the base deck. Returns what a person is to read, on rank 0. DeckError, FileError; Stopped
/// when `stop_asked` gives a reason. `report_file`: a report that is renewed meanwhile; none when it is empty.
std::string calibrate_file(const Communicator& world, const RunRequest& request, const StopAsked& stop_asked,
                           const std::string& report_file);

/// Collective. What calibrate_file would run first, and what that takes; runs and writes nothing. Returns lines for a
/// person, on rank 0. DeckError and FileError as calibrate_file before its first run.
std::string check_calibration(const Communicator& world, const RunRequest& request);

/// Collective. Estimates again from the runs in `directory`, without any new one: with the laboratory values of the
/// calibration deck `deck`, or of the directory's own when it is empty.
std::string estimate_directory(const Communicator& world, const std::string& directory, const std::string& deck);

}  // namespace repose
