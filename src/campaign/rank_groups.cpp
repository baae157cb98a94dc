#include "campaign/rank_groups.h"

#include <algorithm>

namespace repose {

int group_count(int ranks, std::int64_t ranks_per_run, std::int64_t runs) {
  return static_cast<int>(std::max<std::int64_t>(1, std::min(ranks / ranks_per_run, runs)));
}

int group_of(int rank, int ranks, int groups) {
  return static_cast<int>(static_cast<std::int64_t>(rank) * groups / ranks);
}

}  // namespace repose
