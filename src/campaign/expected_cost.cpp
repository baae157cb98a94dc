#include "campaign/expected_cost.h"

#include <algorithm>
#include <limits>

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
                                       std::span<const ParameterDeck> parameters) {
  constexpr double unknown = std::numeric_limits<double>::infinity();
  std::vector<double> cost(runs.size(), unknown);
  std::vector<std::size_t> waiting;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (records[i].state != RunState::waiting) continue;
    waiting.push_back(i);
    double least = unknown;
    for (std::size_t j = 0; j < runs.size(); ++j) {
      if (records[j].state != RunState::done && records[j].state != RunState::plugged) continue;
      const double distance = squared_distance(runs[i], runs[j], parameters);
      if (distance >= least) continue;
      least = distance;
      cost[i] = records[j].wall_seconds * records[j].ranks;
    }
  }
  std::stable_sort(waiting.begin(), waiting.end(), [&](std::size_t a, std::size_t b) { return cost[a] > cost[b]; });
  return waiting;
}

}  // namespace repose
