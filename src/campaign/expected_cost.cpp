#include "campaign/expected_cost.h"

#include <algorithm>
#include <limits>
#include <map>

namespace repose {
namespace {

double squared_distance(const StudyRun& a, const StudyRun& b, std::span<const ParameterDeck> parameters) {
  double sum = 0.0;
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const double difference = (a.values[k] - b.values[k]) / (parameters[k].max - parameters[k].min);
    sum += difference * difference;
  }
  return sum;
}

}  // namespace

std::vector<std::size_t> longest_first(std::span<const StudyRun> runs, std::span<const RunRecord> records,
                                       std::span<const ParameterDeck> parameters, const WorkOf& work_of) {
  const auto waits = [](const RunRecord& record) { return record.state == RunState::waiting; };
  if (std::none_of(records.begin(), records.end(), waits)) return {};  // the work of a run takes its set-up
  std::map<std::vector<double>, double> work;                          // that of one seed is that of all
  for (const StudyRun& run : runs) {
    if (!work.contains(run.values)) work[run.values] = std::max(work_of(run), 1.0);
  }
  std::vector<double> cost(runs.size(), 0.0);
  std::vector<std::size_t> waiting;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (records[i].state != RunState::waiting) continue;
    waiting.push_back(i);
    double least = std::numeric_limits<double>::infinity();
    double speed = 1.0;
    for (std::size_t j = 0; j < runs.size(); ++j) {
      if (records[j].state != RunState::done && records[j].state != RunState::plugged) continue;
      const double distance = squared_distance(runs[i], runs[j], parameters);
      if (distance >= least) continue;
      least = distance;
      speed = work[runs[j].values] / std::max(records[j].wall_seconds * records[j].ranks, 1e-3);
    }
    cost[i] = work[runs[i].values] / speed;
  }
  std::stable_sort(waiting.begin(), waiting.end(), [&](std::size_t a, std::size_t b) { return cost[a] > cost[b]; });
  return waiting;
}

}  // namespace repose
