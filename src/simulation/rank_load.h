#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "comm/communicator.h"
#include "neighbours/pair_lists.h"
#include "scene/particles/particles.h"

namespace repose {

/// What each owned particle costs in a step, in pairs to evaluate, for the decomposition: itself and the pairs that
/// this rank evaluates for it. Counted, never timed.
std::vector<std::int64_t> cost_of_owned(const PairLists& pairs, const Particles& particles);

/// The load of one rank: counts of its steps since the set-up, and how they compare with those of the other ranks.
class RankLoad {
 public:
  explicit RankLoad(const Communicator& comm) : before_(comm.traffic()) {}

  /// After each step: the pairs evaluated in it, and the ghosts.
  void count_step(std::size_t pairs, std::size_t ghosts) {
    ++steps_;
    pairs_ += static_cast<std::int64_t>(pairs);
    ghosts_ += static_cast<std::int64_t>(ghosts);
  }
  /// Collective, after the same steps on all ranks. Compares the pairs evaluated since the last call.
  void compare(const Communicator& comm);

  std::int64_t steps() const { return steps_; }
  double pairs_per_step() const { return per_step(pairs_); }
  double ghosts_per_step() const { return per_step(ghosts_); }
  /// All that was sent over the communicator.
  Traffic traffic(const Communicator& comm) const;
  double per_step(std::int64_t count) const {
    return steps_ > 0 ? static_cast<double>(count) / static_cast<double>(steps_) : 0.0;
  }
  /// Pairs of the busiest rank over the mean, averaged over the steps that were compared; the same on all ranks.
  double imbalance() const { return compared_steps_ > 0 ? imbalance_ / static_cast<double>(compared_steps_) : 1.0; }

 private:
  Traffic before_;  ///< of the communicator, until the set-up was done
  std::int64_t steps_ = 0;
  std::int64_t pairs_ = 0;
  std::int64_t ghosts_ = 0;
  std::int64_t compared_steps_ = 0;
  std::int64_t compared_pairs_ = 0;
  double imbalance_ = 0.0;  ///< summed over the steps
};

}  // namespace repose
