#pragma once

#include <optional>
#include <string>
#include <vector>

#include "run/run.h"

namespace repose {

/// A deck in a file and how it is to be run.
struct RunRequest {
  std::string deck;                    ///< path
  std::vector<std::string> overrides;  ///< "key=value", in order
  std::string output;                  ///< directory of the results
  VectorLevel level;
  RunLog log;
  bool restart = false;  ///< go on where an earlier process has stopped
};

/// Collective. Runs the deck. Empty when it is asked to go on and the directory holds the complete results already.
/// Throws as run_deck (run.h) and read_deck do.
std::optional<Summary> run_file(const Communicator& comm, const RunRequest& request, const StopAsked& stop_asked);

}  // namespace repose
