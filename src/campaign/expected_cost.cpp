#include "campaign/expected_cost.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

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

bool is_same_test(const StudyRun& a, const StudyRun& b) { return a.level == b.level && a.experiment == b.experiment; }

/// A run of another test or level tells less of the speed than any of the same.
double other_test(const StudyRun& a, const StudyRun& b) {
  constexpr double far = 1e6;
  return is_same_test(a, b) ? 0.0 : far;
}

}  // namespace

double expected_particle_steps(std::span<const StudyRun> runs, std::span<const RunRecord> records,
                               std::span<const ParameterDeck> parameters, std::size_t level, std::size_t experiment,
                               const std::vector<double>& values) {
  constexpr double near = 0.01;  // squared, over the ranges: nearer runs are worth the same
  const StudyRun there{values, 0, "", {}, level, experiment};
  double weights = 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!is_same_test(runs[i], there) || !(records[i].particle_steps > 0.0)) continue;
    const double weight = 1.0 / (near + squared_distance(runs[i], there, parameters));
    weights += weight;
    sum += weight * std::log(records[i].particle_steps);
  }
  return weights > 0.0 ? std::exp(sum / weights) : 1.0;
}

std::vector<std::size_t> begun_then_longest(std::span<const StudyRun> runs, std::span<const RunRecord> records,
                                            std::span<const ParameterDeck> parameters, const WorkOf& work_of) {
  const auto waits = [](const RunRecord& record) { return record.state == RunState::waiting; };
  if (std::none_of(records.begin(), records.end(), waits)) return {};  // the work of a run takes its set-up
  std::map<std::tuple<std::size_t, std::size_t, std::vector<double>>, double> work;  // that of one seed is that of all
  const auto key_of = [](const StudyRun& run) { return std::tuple(run.experiment, run.level, run.values); };
  for (const StudyRun& run : runs) {
    if (!work.contains(key_of(run))) work[key_of(run)] = std::max(work_of(run), 1.0);
  }
  std::vector<double> cost(runs.size(), 0.0);
  std::vector<std::size_t> waiting;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (records[i].state != RunState::waiting) continue;
    waiting.push_back(i);
    double least = std::numeric_limits<double>::infinity();
    double speed = 1.0;
    for (std::size_t j = 0; j < runs.size(); ++j) {
      if (!is_complete(records[j].state)) continue;
      const double distance = squared_distance(runs[i], runs[j], parameters) + other_test(runs[i], runs[j]);
      if (distance >= least) continue;
      least = distance;
      speed = work[key_of(runs[j])] / std::max(records[j].wall_seconds * records[j].ranks, 1e-3);
    }
    cost[i] = work[key_of(runs[i])] / speed;
  }
  std::stable_sort(waiting.begin(), waiting.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(records[a].has_checkpoint, cost[a]) > std::pair(records[b].has_checkpoint, cost[b]);
  });
  return waiting;
}

}  // namespace repose
