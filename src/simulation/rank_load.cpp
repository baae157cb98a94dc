#include "simulation/rank_load.h"

namespace repose {

std::vector<std::int64_t> cost_of_owned(const PairLists& pairs, const Particles& particles) {
  constexpr std::int64_t particle_cost = 2;
  std::vector<std::int64_t> cost = pairs.pairs_of_owned(particles);
  for (std::int64_t& c : cost) c += particle_cost;
  return cost;
}

void RankLoad::compare(const Communicator& comm) {
  const std::int64_t steps = steps_ - compared_steps_;
  const std::int64_t here = pairs_ - compared_pairs_;
  compared_steps_ = steps_;
  compared_pairs_ = pairs_;
  if (steps == 0) return;
  const std::int64_t busiest = comm.size() == 1 ? here : comm.max(here);
  const std::int64_t all = comm.size() == 1 ? here : comm.sum(here);
  const double ratio = all > 0 ? static_cast<double>(busiest) * comm.size() / static_cast<double>(all) : 1.0;
  imbalance_ += ratio * static_cast<double>(steps);
}

Traffic RankLoad::traffic(const Communicator& comm) const {
  const Traffic& now = comm.traffic();
  return {now.messages - before_.messages, now.bytes - before_.bytes, now.collectives - before_.collectives};
}

}  // namespace repose
