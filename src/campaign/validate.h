#pragma once

#include <string>
#include <vector>

#include "run/run_file.h"

namespace repose {

/// Collective. Runs the cases of a validation deck (deck/validation_deck.h), or only those with these names, each in a
/// folder of its own in the output directory, with the overrides of the request behind those of the case; goes on where
/// an earlier call has stopped. Writes validation.json and validation.md there and returns the table of the latter, on
/// rank 0. Throws as run_file does; DeckError, before anything is simulated, when the deck of a case is wrong, a figure
/// is not measured, a name is of no case, or the directory holds results of another kind.
std::string validate_file(const Communicator& comm, const RunRequest& request, const std::vector<std::string>& only,
                          const StopAsked& stop_asked);

/// Collective. What all its cases would run, as check_calibration says it.
std::string check_validation(const Communicator& comm, const RunRequest& request);

}  // namespace repose
