#include <filesystem>

#include "comm/agreement.h"
#include "files/step_file.h"
#include "run/recorder.h"
#include "run/snapshot_files.h"

namespace repose {

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

/// What an earlier run has left in the same directory would pass for this one's.
void Recorder::remove_earlier_results() const {
  for (const char* name : {"summary.json", "run.hdf.series", "trace.csv", "walls.csv"}) {
    std::filesystem::remove(path(name));
  }
  for (const MeasurementKind& kind : measurement_kinds()) {
    for (const std::string& name : kind.files) std::filesystem::remove(path(name));
  }
  remove_snapshots_after(-1);
}

void Recorder::remove_snapshots_after(std::int64_t step) const {
  for (const auto& entry : std::filesystem::directory_iterator(options_.directory)) {
    const std::string name = entry.path().filename().string();
    for (const StepFiles& files : {snapshot_files, neighbourhood_files, contacts_files, walls_files}) {
      const auto of = step_of_file(name, files.prefix, files.ending);
      if (of && *of > step && !entry.is_directory()) std::filesystem::remove(entry.path());
    }
  }
}

}  // namespace repose
