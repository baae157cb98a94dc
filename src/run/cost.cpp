#include "run/cost.h"

#include <array>
#include <span>

#include <sys/resource.h>

namespace repose {
namespace {

RankSpread spread_of(const Communicator& comm, double here) {
  return {comm.min(here), comm.sum(here) / comm.size(), comm.max(here)};
}

/// Processor time of what a rank does without waiting for others.
double work_cpu_seconds(const StageClock& clock) {
  const StageClock::Seconds cpu = clock.estimated_cpu_seconds();
  double seconds = 0.0;
  for (const Stage stage : {Stage::pair_contacts, Stage::wall_contacts, Stage::integration}) {
    seconds += cpu[static_cast<std::size_t>(stage)];
  }
  return seconds;
}

ParallelSummary summarise_division(const Simulation& simulation, double cpu_seconds) {
  const Communicator& comm = simulation.comm();
  RankLoad load = simulation.load();
  const Traffic traffic = load.traffic(comm);  // before the next collective calls
  load.compare(comm);
  return {.bisections = simulation.counters().bisections,
          .imbalance = load.imbalance(),
          .loop_cpu_seconds = spread_of(comm, cpu_seconds),
          .work_cpu_seconds = spread_of(comm, work_cpu_seconds(simulation.clock())),
          .pairs_per_step = spread_of(comm, load.pairs_per_step()),
          .ghosts_per_step = spread_of(comm, load.ghosts_per_step()),
          .messages_per_step = spread_of(comm, load.per_step(traffic.messages)),
          .bytes_per_step = spread_of(comm, load.per_step(traffic.bytes)),
          .collectives_per_step = load.per_step(traffic.collectives)};
}

}  // namespace

LoopCost loop_cost(const Simulation& simulation, double cpu_seconds) {
  const Communicator& comm = simulation.comm();
  LoopCost cost;
  cost.parallel = summarise_division(simulation, cpu_seconds);
  std::array<double, stage_names.size()> sum = simulation.clock().seconds();
  std::array<double, stage_names.size()> longest = sum;
  comm.sum_elements(std::span(sum.begin(), sum.end()));
  comm.max_elements(std::span(longest.begin(), longest.end()));
  for (std::size_t k = 0; k < sum.size(); ++k) {
    cost.stages.push_back({stage_names[k], sum[k] / comm.size(), longest[k]});
  }

  cost.list_rebuilds = simulation.counters().rebuilds;
  cost.inner_selections = comm.max(simulation.counters().inner_selections);
  const auto inserted = static_cast<double>(simulation.inserted());
  const auto per_particle = [&](std::size_t count) {
    return static_cast<double>(comm.sum(static_cast<std::int64_t>(count))) / inserted;
  };
  cost.listed_pairs_per_particle = per_particle(simulation.pairs().listed());
  cost.evaluated_pairs_per_particle = per_particle(simulation.pairs().lanes());

  const auto ghosts = static_cast<std::int64_t>(simulation.particles().ghosts());
  cost.ghosts = comm.sum(ghosts);
  cost.most_ghosts_of_a_rank = comm.max(simulation.counters().peak_ghosts);

  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  cost.memory_peak_bytes = comm.sum(std::int64_t{1024} * usage.ru_maxrss);
  cost.memory_bytes_per_particle = per_particle(simulation.memory_bytes());
  return cost;
}

}  // namespace repose
