#pragma once

#include <string>

#include "output/build_info.h"
#include "output/run_log.h"

namespace repose {

/// Where and how a run's results go.
struct OutputOptions {
  std::string directory;
  std::string resolved_deck;
  BuildInfo build;
  RunLog log;
  bool restart = false;  ///< go on from the newest checkpoint in the directory, if there is one
};

}  // namespace repose
