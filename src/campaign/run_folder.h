#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "campaign/run_list.h"

namespace repose {

/// How far a run of a study has come.
enum class RunState { waiting, running, done, plugged, failed };

const char* to_string(RunState state);

/// Whether it came to its end, and so has figures.
constexpr bool is_complete(RunState state) { return state == RunState::done || state == RunState::plugged; }

/// What the folder of a run says. The folders are the truth; tables are made from them.
struct RunRecord {
  RunState state = RunState::waiting;
  ExitCode failure = ExitCode::done;           ///< with which it failed, last
  std::string reason;                          ///< the message of that; it may wait to be tried again
  std::vector<std::optional<double>> figures;  ///< those that were asked for; none where the run has none
  std::string state_hash;
  double wall_seconds = 0.0;
  int ranks = 0;
  std::int64_t restarts = 0;
  double particle_steps = 0.0;       ///< its work: grains times steps, which no rank or clock changes; 0: not known
  bool has_checkpoint = false;       ///< it waits, but was begun
  std::vector<std::string> overdue;  ///< phases that max_time ended, not what they waited for
};

/// Reads a run's folder, which need not exist. A run that failed for what may be gone by now (a full disk, a deck that
/// was wrong) waits again; one whose physics broke would break again. FileError when a file cannot be read.
RunRecord read_run_folder(const std::string& folder, std::span<const std::string> figures);

/// A figure that the runs of one experiment are asked for.
struct RunFigure {
  std::string column;  ///< its name in tables
  std::string key;     ///< of summary.json
  std::size_t experiment = 0;
};

/// The folder of a run in the directory of its study: runs/NAME.
std::string folder_of(const std::string& directory, const StudyRun& run);

/// Reads the folders of all runs; a run has none of the figures of other experiments.
std::vector<RunRecord> read_run_folders(const std::string& directory, std::span<const StudyRun> runs,
                                        std::span<const RunFigure> figures);

/// Notes in the folder why its run has failed.
void write_failure(const std::string& folder, ExitCode code, const std::string& reason);
/// Takes the note away, before the run is tried again.
void remove_failure(const std::string& folder);

}  // namespace repose
