#pragma once

#include <span>
#include <string>
#include <vector>

#include "campaign/run_folder.h"
#include "campaign/run_list.h"
#include "output/build_info.h"

namespace repose {

/// Runs and what has become of them: one row per run, in the order of the runs.
struct GridTable {
  std::string deck;                      ///< of the study, as it was given
  std::vector<std::string> parameters;   ///< names
  std::vector<std::string> figures;      ///< their columns
  std::vector<std::string> levels;       ///< names; empty: there is one level
  std::vector<std::string> experiments;  ///< likewise
  std::span<const StudyRun> runs;
  std::span<const RunRecord> records;
  BuildInfo build;
};

/// Writes grid.h5 and grid.csv to the directory, each whole or not at all. A figure that a run does not have is NaN in
/// the one, empty in the other. Times and restarts, which no result depends on, are in /effort of grid.h5 alone. For
/// one rank; FileError names the file.
void write_grid_table(const std::string& directory, const GridTable& table);

}  // namespace repose
