#pragma once

#include <chrono>
#include <ctime>
#include <memory>
#include <optional>
#include <string>

#include "measurement/discharge.h"
#include "measurement/tilt_onset.h"
#include "output/build_info.h"
#include "output/snapshot_series.h"
#include "output/summary.h"
#include "output/time_series.h"
#include "output/trace.h"
#include "phases.h"
#include "simulation.h"
#include "surface_angle_series.h"
#include "wall_load_series.h"

namespace repose {

/// Where and how a run's results go.
struct OutputOptions {
  std::string directory;
  std::string resolved_deck;
  BuildInfo build;
  bool quiet = false;  ///< no progress lines
};

/// Watches a running simulation: samples the discharge, writes the time series, the trace, the snapshots and the
/// progress lines when they are due, and measures everything at the end. All members but the constructor's plain copies
/// are collective; only rank 0 writes text.
class Recorder {
 public:
  Recorder(const Simulation& simulation, const OutputOptions& options);

  void phase_begins(const Simulation& simulation, const Phase& phase);
  /// Steps until something is due again: call steps_done after at most so many.
  std::int64_t steps_to_next(const Simulation& simulation) const;
  void steps_done(const Simulation& simulation, const Phase& phase);
  void phase_ended(const Simulation& simulation, const Phase& phase, const std::string& ended_by);

  /// Last snapshot, angle of repose and silhouette picture, summary.json. The summary is complete on rank 0.
  Summary finish(const Simulation& simulation, const ReadFile& read_file);
  bool onset_seen() const { return tilt_onset_ && tilt_onset_->onset(); }

 private:
  /// What is to be done at a step.
  struct Due {
    bool trace, check, series, snapshot, surface_angle;
    bool anything() const { return trace || check || series || snapshot || surface_angle; }
  };
  Due due_at(std::int64_t step, const Deck& deck) const;
  void remove_earlier_results() const;
  void sample_discharge(const Simulation& simulation);
  void write_series_row(const Simulation& simulation, const std::string& phase);
  void write_trace(const Simulation& simulation);
  void write_snapshot_now(const Simulation& simulation);
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
  DischargeRecord discharge_;
  std::optional<TiltOnset> tilt_onset_;
  std::optional<SurfaceAngleSeries> surface_angle_;
  std::optional<WallLoadSeries> wall_loads_;
  std::unique_ptr<TimeSeries> series_;  ///< rank 0
  std::unique_ptr<Trace> trace_;        ///< rank 0
  SnapshotSeries snapshots_;
  std::vector<PhaseSummary> phases_;
  std::chrono::steady_clock::time_point start_;
  std::clock_t cpu_start_ = std::clock();
  std::chrono::steady_clock::time_point last_progress_;
  std::int64_t last_progress_step_ = 0;
  double particle_steps_ = 0.0;
  std::int64_t counted_steps_ = 0;  ///< of it
  std::int64_t inside_ = 0;         ///< at the last check
};

}  // namespace repose
