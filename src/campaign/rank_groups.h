#pragma once

#include <cstdint>

namespace repose {

/// How many groups of at least `ranks_per_run` ranks work at the same time: no more than there are runs.
int group_count(int ranks, std::int64_t ranks_per_run, std::int64_t runs);

/// The group of a rank, 0 to groups - 1: successive ranks, as evenly as can be. Ranks that are left over join groups
/// rather than idle.
int group_of(int rank, int ranks, int groups);

}  // namespace repose
