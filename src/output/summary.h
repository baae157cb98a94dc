#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "output/build_info.h"
#include "output/run_cost.h"
#include "scene/sizes/size_report.h"

namespace repose {

/// One phase as it went.
struct PhaseSummary {
  std::string name;
  std::int64_t steps = 0;
  std::string ended_by;  ///< the condition that held, or max_time

  template <class Self, class Visitor>
  static void describe_state(Self& self, Visitor& v) {
    v("name", self.name);
    v("steps", self.steps);
    v("ended_by", self.ended_by);
  }
};

/// What left by one exit: a named one, or the rest of a face of the domain.
struct ExitSummary {
  std::string name;
  std::int64_t particles = 0;
  double mass_kg = 0.0;
};

/// What is known of a run at its end.
struct Summary {
  std::string status;
  std::string title;
  int ranks = 1;
  std::int64_t steps = 0;
  double time_s = 0.0;
  double timestep_s = 0.0;
  std::string timestep_set_by;  ///< the criterion
  std::int64_t planned = 0;     ///< in all; those inserted are the ones that have entered by the end
  std::int64_t inserted = 0;
  std::int64_t inside = 0;
  std::int64_t left = 0;
  std::vector<ExitSummary> exits;
  std::vector<SizeReport> sizes;  ///< of the blocks with [particles.sizes]
  std::string state_hash;
  std::vector<PhaseSummary> phases;
  nlohmann::ordered_json figures =
      nlohmann::ordered_json::object();  ///< what was measured, by key; null: nothing there
  std::int64_t restarts = 0;             ///< from checkpoints
  double wall_seconds = 0.0;             ///< with what the earlier processes took until their last checkpoint
  double particle_steps_per_second = 0.0;
  double loop_wall_seconds = 0.0;  ///< of the time loop alone, without set-up and final measurements, since the restart
  double loop_cpu_seconds = 0.0;   ///< the same, processor time of all ranks
  double particle_steps_per_cpu_second = 0.0;
  CheckpointCost checkpoints;
  LoopCost cost;
  BuildInfo build;
  std::string deck;  ///< resolved, TOML
};

/// The summary as JSON; empty and non-finite numbers become null.
std::string summary_json(const Summary& summary);

/// Writes the summary to `path`, whole or not at all. Throws FileError. For rank 0.
void write_summary(const std::string& path, const Summary& summary);

}  // namespace repose
