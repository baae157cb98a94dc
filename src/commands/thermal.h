#pragma once

#include <string>
#include <vector>

#include "comm/communicator.h"

namespace repose {

/// What a thermal tool is asked to do.
struct ThermalRequest {
  std::string tool;                    ///< bed, network, tps, synthesise, sensor, mixture, compare
  std::string deck;                    ///< path
  std::vector<std::string> overrides;  ///< "key=value", in order
  std::vector<std::string> files;      ///< paths of data, for the tools that take some
  std::string output;                  ///< directory of <tool>.json and further files; may be empty
};

/// Collective. Rank 0 runs the tool; the table that is to be printed comes back on it. Throws DeckError and FileError
/// on all ranks.
std::string run_thermal_tool(const Communicator& comm, const ThermalRequest& request);

}  // namespace repose
