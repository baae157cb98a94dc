#pragma once

#include <ctime>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>

#include "base/wall_clock.h"
#include "output/snapshot_series.h"
#include "output/summary.h"
#include "output/time_series.h"
#include "output/trace.h"
#include "run/measurements/measurement.h"
#include "run/output_options.h"
#include "run/wall_load_series.h"
#include "simulation/phases.h"
#include "simulation/simulation.h"

namespace repose {

/// What a run has cost so far, over all processes that worked on it one after the other.
struct Effort {
  double wall_seconds = 0.0;
  double particle_steps = 0.0;
  std::int64_t restarts = 0;

  template <class Self, class Visitor>
  static void describe_state(Self& self, Visitor& v) {
    v("wall_seconds", self.wall_seconds);
    v("particle_steps", self.particle_steps);
    v("restarts", self.restarts);
  }
};

/// Whether a file with this name in the output directory is a run's, which another run there removes or writes anew.
bool is_result(const std::string& name);

/// Watches a running simulation: leads the measurements, writes the time series, the trace, the snapshots and the
/// progress lines when they are due. All members but the constructor's plain copies are collective; only rank 0 writes
/// text.
class Recorder {
 public:
  /// Begins the files anew, or goes on with those of an earlier process: then its state is to be read (describe_state)
  /// and resume to be called.
  Recorder(const Simulation& simulation, const OutputOptions& options, Existing existing);
  /// Removes what the earlier process wrote after its checkpoint.
  void resume(const Simulation& simulation);
  /// Brings to the disk what is in the files so far: to be called before a checkpoint is written.
  void sync_files(const Communicator& comm);

  void phase_begins(const Simulation& simulation, const Phase& phase);
  /// Steps until something is due again: call steps_done after at most so many.
  std::int64_t steps_to_next(const Simulation& simulation) const;
  void steps_done(const Simulation& simulation, const Phase& phase);
  void phase_ended(const Simulation& simulation, const Phase& phase, const std::string& ended_by);

  /// Last snapshot, angle of repose and silhouette picture, summary.json. The summary is complete on rank 0.
  Summary finish(const Simulation& simulation, const ReadFile& read_file, const CheckpointCost& checkpoints);
  /// Whether a measurement has seen what a phase with this condition waits for.
  bool has_seen(PhaseUntil condition) const;

  /// That of rank 0 counts, which holds the files.
  template <class Self, class Visitor>
  static void describe_state(Self& self, Visitor& v) {
    v("settled_steps", self.settled_steps_);
    v("last_snapshot", self.last_snapshot_);
    v("last_series", self.last_series_);
    v("opened", self.opened_);
    v("snapshots", self.snapshots_);
    v("phases", self.phases_);
    for (const auto& [kind, watch] : self.watches_) v(kind->section.c_str(), *watch);
    if (self.wall_loads_) v("wall_loads", *self.wall_loads_);
    if (self.series_) v("series", *self.series_);
    if (self.trace_) v("trace", *self.trace_);
    if constexpr (std::is_const_v<Self>) {
      v("effort", self.effort());
    } else {
      v("effort", self.earlier_);
    }
  }

 private:
  /// What is to be done at a step.
  struct Due {
    bool trace, check, series, snapshot, sample;
    bool anything() const { return trace || check || series || snapshot || sample; }
  };
  bool is_asked_for(std::int64_t step) const;  ///< a snapshot, by output.snapshot_times
  Due due_at(std::int64_t step, const Deck& deck) const;
  Effort effort() const;
  void remove_earlier_results() const;
  void remove_snapshots_after(std::int64_t step) const;
  Figures measured(const Simulation& simulation, const ReadFile& read_file, std::int64_t left) const;
  void write_series_row(const Simulation& simulation, const std::string& phase);
  void write_trace(const Simulation& simulation);
  void write_snapshot_now(const Simulation& simulation);
  void write_contacts(const Simulation& simulation);
  void write_walls(const Simulation& simulation);
  void report_absent(const Summary& s) const;
  void report_progress(const Simulation& simulation, const Phase& phase);
  std::int64_t inside(const Simulation& simulation) const;
  std::string path(const std::string& file) const { return options_.directory + "/" + file; }

  OutputOptions options_;
  std::int64_t total_steps_;        ///< the longest the run can take
  std::int64_t settled_steps_ = 0;  ///< of it, what the phases that are over could have taken
  std::int64_t series_every_;
  std::int64_t snapshot_every_;  ///< 0: never
  std::vector<std::int64_t> snapshot_steps_;
  std::int64_t last_snapshot_ = -1;  ///< step
  std::int64_t last_series_ = -1;    ///< step
  std::string opening_phase_;        ///< the first that removes a wall; the first of all when none does
  bool opened_ = false;
  struct Watched {
    const MeasurementKind* kind;
    std::unique_ptr<Watch> watch;
  };
  std::vector<Watched> watches_;
  std::optional<WallLoadSeries> wall_loads_;
  std::unique_ptr<TimeSeries> series_;  ///< rank 0
  std::unique_ptr<Trace> trace_;        ///< rank 0
  SnapshotSeries snapshots_;
  std::vector<PhaseSummary> phases_;
  WallClock::time_point start_;
  std::clock_t cpu_start_ = std::clock();
  WallClock::time_point last_progress_;
  std::int64_t last_progress_step_ = 0;
  Effort earlier_;                  ///< of the processes before this one
  double particle_steps_ = 0.0;     ///< of this one
  std::int64_t counted_steps_ = 0;  ///< of it
  std::int64_t inside_ = 0;         ///< at the last check
};

}  // namespace repose
