#include "cost.h"

#include <array>
#include <span>

#include <sys/resource.h>

namespace repose {

void summarise_cost(const Simulation& simulation, Summary& summary) {
  const Communicator& comm = simulation.comm();
  std::array<double, stage_names.size()> sum = simulation.clock().seconds();
  std::array<double, stage_names.size()> longest = sum;
  comm.sum_elements(std::span(sum.begin(), sum.end()));
  comm.max_elements(std::span(longest.begin(), longest.end()));
  for (std::size_t k = 0; k < sum.size(); ++k) {
    summary.stages.push_back({stage_names[k], sum[k] / comm.size(), longest[k]});
  }

  summary.list_rebuilds = simulation.counters().rebuilds;
  summary.inner_selections = simulation.counters().inner_selections;
  const auto inserted = static_cast<double>(simulation.inserted());
  const auto per_particle = [&](std::size_t count) {
    return static_cast<double>(comm.sum(static_cast<std::int64_t>(count))) / inserted;
  };
  summary.listed_pairs_per_particle = per_particle(simulation.pairs().listed());
  summary.evaluated_pairs_per_particle = per_particle(simulation.pairs().lanes());

  const auto ghosts = static_cast<std::int64_t>(simulation.particles().ghosts());
  summary.ghosts = comm.sum(ghosts);
  summary.most_ghosts_of_a_rank = comm.max(simulation.counters().peak_ghosts);

  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  summary.memory_peak_bytes = comm.sum(std::int64_t{1024} * usage.ru_maxrss);
  summary.memory_bytes_per_particle = per_particle(simulation.memory_bytes());
}

}  // namespace repose
