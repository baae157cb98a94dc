#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "campaign/run_list.h"

namespace repose {

/// An order of runs in parts that want the same number of ranks, the fewest first; within a part as they were.
std::vector<std::vector<std::size_t>> by_ranks(std::span<const std::size_t> order, std::span<const StudyRun> runs);

/// How many groups of at least `ranks_per_run` ranks work at the same time: no more than there are runs.
int group_count(int ranks, std::int64_t ranks_per_run, std::int64_t runs);

/// The group of a rank, 0 to groups - 1: successive ranks, as evenly as can be. Ranks that are left over join groups
/// rather than idle.
int group_of(int rank, int ranks, int groups);

}  // namespace repose
