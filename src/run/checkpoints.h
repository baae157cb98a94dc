#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/wall_clock.h"
#include "comm/communicator.h"
#include "deck/deck.h"
#include "output/checkpoint_reader.h"
#include "output/run_cost.h"
#include "output/run_log.h"

namespace repose {

/// The checkpoints of a run in its output directory, checkpoint_<step>.hdf: when the next is due, and how many stay.
class Checkpoints {
 public:
  Checkpoints(const OutputDeck& deck, std::string directory);

  /// Steps until one is due by their number.
  std::int64_t steps_to_next(std::int64_t step) const;
  bool is_due_at(std::int64_t step) const { return every_ > 0 && step % every_ == 0; }
  /// By wall time on this rank: rank 0 has to decide for all.
  bool is_due_by_time() const;

  /// Collective. Writes one, which then is the newest, and removes all older ones but the one before it.
  void write(const Communicator& comm, const CheckpointHeader& header, const Particles& particles,
             const ContactMemory& memory);
  const CheckpointCost& cost() const { return cost_; }

 private:
  std::string directory_;
  std::int64_t every_;  ///< steps, or 0
  double minutes_;      ///< or 0
  WallClock::time_point last_;
  CheckpointCost cost_;
};

/// The paths of the checkpoints in a directory, the newest first. For one rank.
std::vector<std::string> checkpoints_in(const std::string& directory);

/// Removes them all, and what is left of one that was not completed. For one rank.
void remove_checkpoints(const std::string& directory);

/// A checkpoint and where it was.
struct FoundCheckpoint {
  std::string path;
  Checkpoint checkpoint;
};

/// Collective. The newest checkpoint in a directory that is whole; of each damaged one a warning. Empty when
/// there is none at all. FileError on all ranks when all are damaged.
std::optional<FoundCheckpoint> newest_checkpoint(const Communicator& comm, const std::string& directory,
                                                 const RunLog& log);

}  // namespace repose
