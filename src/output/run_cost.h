#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace repose {

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

/// What the time loop has cost.
struct LoopCost {
  std::vector<StageSummary> stages;
  std::int64_t list_rebuilds = 0;
  std::int64_t inner_selections = 0;          ///< new inner lists between two rebuilds, of the rank with most
  double listed_pairs_per_particle = 0.0;     ///< in the outer lists at the end, each pair once per rank that holds it
  double evaluated_pairs_per_particle = 0.0;  ///< the same of the inner lists
  std::int64_t ghosts = 0;                    ///< of all ranks at the end
  std::int64_t most_ghosts_of_a_rank = 0;     ///< at any time
  ParallelSummary parallel;
  std::int64_t memory_peak_bytes = 0;      ///< resident, of all ranks together
  double memory_bytes_per_particle = 0.0;  ///< of particles, ghosts, neighbour lists and histories
};

}  // namespace repose
