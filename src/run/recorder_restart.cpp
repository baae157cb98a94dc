#include <algorithm>
#include <array>
#include <filesystem>

#include "comm/agreement.h"
#include "files/step_file.h"
#include "run/recorder.h"
#include "run/snapshot_files.h"

namespace repose {
namespace {

/// What a run begins with anew, and what it removes of an earlier one, beside the files of measurements and of steps.
constexpr std::array<const char*, 2> rewritten = {"deck.resolved.toml", "series.csv"};
constexpr std::array<const char*, 4> removed = {"summary.json", "run.hdf.series", "trace.csv", "walls.csv"};
constexpr std::array<StepFiles, 4> step_files = {snapshot_files, neighbourhood_files, contacts_files, walls_files};

}  // namespace

void Recorder::resume(const Simulation& simulation) {
  ++earlier_.restarts;
  inside_ = inside(simulation);
  counted_steps_ = simulation.steps();
  last_progress_step_ = simulation.steps();
  agree_after_root(simulation.comm(), [&] {
    remove_snapshots_after(simulation.steps());
    snapshots_.rewrite();
  });
}

void Recorder::sync_files(const Communicator& comm) {
  agree_after_root(comm, [&] {
    series_->sync();
    if (trace_) trace_->sync();
    if (wall_loads_) wall_loads_->sync();
    for (const Watched& w : watches_) w.watch->sync();
  });
}

Effort Recorder::effort() const {
  return {earlier_.wall_seconds + seconds_since(start_), earlier_.particle_steps + particle_steps_, earlier_.restarts};
}

bool is_result(const std::string& name) {
  const auto is_it = [&](const std::string& other) { return name == other; };
  if (std::any_of(rewritten.begin(), rewritten.end(), is_it) || std::any_of(removed.begin(), removed.end(), is_it)) {
    return true;
  }
  const auto writes_it = [&](const MeasurementKind& kind) {
    return std::any_of(kind.files.begin(), kind.files.end(), is_it);
  };
  const auto is_of_a_step = [&](const StepFiles& files) {
    return step_of_file(name, files.prefix, files.ending).has_value();
  };
  return std::any_of(measurement_kinds().begin(), measurement_kinds().end(), writes_it) ||
         std::any_of(step_files.begin(), step_files.end(), is_of_a_step);
}

/// What an earlier run has left in the same directory would pass for this one's.
void Recorder::remove_earlier_results() const {
  for (const char* name : removed) std::filesystem::remove(path(name));
  for (const MeasurementKind& kind : measurement_kinds()) {
    for (const std::string& name : kind.files) std::filesystem::remove(path(name));
  }
  remove_snapshots_after(-1);
}

void Recorder::remove_snapshots_after(std::int64_t step) const {
  for (const auto& entry : std::filesystem::directory_iterator(options_.directory)) {
    const std::string name = entry.path().filename().string();
    for (const StepFiles& files : step_files) {
      const auto of = step_of_file(name, files.prefix, files.ending);
      if (of && *of > step && !entry.is_directory()) std::filesystem::remove(entry.path());
    }
  }
}

}  // namespace repose
