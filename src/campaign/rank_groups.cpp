#include "campaign/rank_groups.h"

#include <algorithm>
#include <map>
#include <utility>

namespace repose {

std::vector<std::vector<std::size_t>> by_ranks(std::span<const std::size_t> order, std::span<const StudyRun> runs) {
  std::map<std::int64_t, std::vector<std::size_t>> parts;
  for (const std::size_t run : order) parts[runs[run].ranks].push_back(run);
  std::vector<std::vector<std::size_t>> result;
  for (auto& [ranks, part] : parts) result.push_back(std::move(part));
  return result;
}

int group_count(int ranks, std::int64_t ranks_per_run, std::int64_t runs) {
  return static_cast<int>(std::max<std::int64_t>(1, std::min(ranks / ranks_per_run, runs)));
}

int group_of(int rank, int ranks, int groups) {
  return static_cast<int>(static_cast<std::int64_t>(rank) * groups / ranks);
}

}  // namespace repose
