#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "output/build_info.h"
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

/// Wall time that the ranks spent on one stage of the time loop.
struct StageSummary {
  std::string name;
  double mean_seconds = 0.0;
  double max_seconds = 0.0;  ///< of the busiest rank
};

/// A figure over the ranks.
struct RankSpread {
  double least = 0.0;
  double mean = 0.0;
  double greatest = 0.0;
};

/// How the work was divided among the ranks, and what they said to one another, in the steps of this process.
struct ParallelSummary {
  std::int64_t bisections = 0;  ///< new decompositions since the start of the run
  double imbalance = 1.0;       ///< pairs evaluated by the busiest rank over the mean, averaged over the steps
  RankSpread loop_cpu_seconds;  ///< of the time loop; a rank that waits takes processor time, too
  RankSpread work_cpu_seconds;  ///< of contacts and integration, which wait for nobody
  RankSpread pairs_per_step;    ///< evaluated
  RankSpread ghosts_per_step;
  RankSpread messages_per_step;  ///< sent to other ranks
  RankSpread bytes_per_step;     ///< in them
  double collectives_per_step = 0.0;
};

/// What checkpoints have cost this process.
struct CheckpointCost {
  std::int64_t written = 0;
  double seconds = 0.0;  ///< wall time of all of them
  double longest = 0.0;  ///< s, of the slowest
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
  std::vector<StageSummary> stages;
  CheckpointCost checkpoints;
  std::int64_t list_rebuilds = 0;
  std::int64_t inner_selections = 0;          ///< new inner lists between two rebuilds
  double listed_pairs_per_particle = 0.0;     ///< in the outer lists at the end, each pair once per rank that holds it
  double evaluated_pairs_per_particle = 0.0;  ///< the same of the inner lists
  std::int64_t ghosts = 0;                    ///< of all ranks at the end
  std::int64_t most_ghosts_of_a_rank = 0;     ///< at any time
  ParallelSummary parallel;
  std::int64_t memory_peak_bytes = 0;      ///< resident, of all ranks together
  double memory_bytes_per_particle = 0.0;  ///< of particles, ghosts, neighbour lists and histories
  BuildInfo build;
  std::string deck;  ///< resolved, TOML
};

/// The summary as JSON; empty and non-finite numbers become null.
std::string summary_json(const Summary& summary);

/// Writes the summary to `path`, whole or not at all. Throws FileError. For rank 0.
void write_summary(const std::string& path, const Summary& summary);

}  // namespace repose
