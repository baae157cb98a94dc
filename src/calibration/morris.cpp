#include "calibration/morris.h"

#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/core.h>

#include "base/error.h"
#include "base/philox.h"
#include "calibration/one_at_a_time.h"

namespace repose {
namespace {

/// A whole number from 0 to below `bound`.
class Dice {
 public:
  Dice(std::uint64_t seed, std::uint64_t trajectory) : seed_(seed), trajectory_(trajectory) {}
  std::size_t below(std::size_t bound) {
    const double u = uniform(seed_, trajectory_, RandomStream::morris_design, thrown_++);
    return static_cast<std::size_t>(u * static_cast<double>(bound));
  }

 private:
  std::uint64_t seed_;
  std::uint64_t trajectory_;
  std::uint32_t thrown_ = 0;
};

/// The points of one trajectory, in units of the box (C.20).
std::vector<Vector> trajectory(std::size_t parameters, std::size_t levels, Dice dice) {
  const std::size_t stride = levels / 2;  // half of the levels: then all levels are equally likely
  const auto steps = static_cast<double>(levels - 1);
  Vector at(static_cast<Index>(parameters));
  std::vector<double> step(parameters);
  for (std::size_t j = 0; j < parameters; ++j) {
    const std::size_t low = dice.below(levels - stride);
    const bool upwards = dice.below(2) == 1;
    at[static_cast<Index>(j)] = static_cast<double>(upwards ? low : low + stride) / steps;
    step[j] = static_cast<double>(upwards ? low + stride : low) / steps;  // where it goes
  }
  std::vector<std::size_t> order(parameters);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t j = parameters - 1; j > 0; --j) std::swap(order[j], order[dice.below(j + 1)]);
  std::vector<Vector> points = {at};
  for (const std::size_t j : order) {
    at[static_cast<Index>(j)] = step[j];
    points.push_back(at);
  }
  return points;
}

MorrisEffect summary(const std::vector<double>& effects) {
  std::vector<double> absolute = effects;
  for (double& effect : absolute) effect = std::fabs(effect);
  const SeedSample with_sign = seed_sample(effects);
  const SeedSample without = seed_sample(absolute);
  return {.mean = with_sign.mean,
          .mean_absolute = without.mean,
          .deviation = with_sign.deviation,
          .mean_error = with_sign.deviation / std::sqrt(with_sign.runs),
          .mean_absolute_error = without.deviation / std::sqrt(without.runs),
          .effects = with_sign.runs};
}

}  // namespace

std::vector<std::vector<double>> morris_design(const std::vector<ParameterRange>& ranges, std::size_t trajectories,
                                               std::size_t levels, std::uint64_t seed) {
  if (levels < 2 || levels % 2 != 0) {
    throw DeckError(fmt::format("Morris screening: {} levels; they must be an even number, such as 4", levels));
  }
  if (trajectories == 0 || ranges.empty()) {
    throw DeckError("Morris screening: needs a parameter and a trajectory or more");
  }
  std::vector<std::vector<double>> points;
  for (std::uint64_t t = 0; t < trajectories; ++t) {
    for (const Vector& point : trajectory(ranges.size(), levels, Dice(seed, t))) {
      points.push_back(from_box(ranges, point));
    }
  }
  return points;
}

std::vector<MorrisEffect> morris_effects(const std::vector<ParameterRange>& ranges,
                                         std::span<const std::vector<double>> points, std::span<const double> values) {
  if (points.size() != values.size() || points.size() % (ranges.size() + 1) != 0) {
    throw DeckError(fmt::format("Morris screening: {} values for {} points in trajectories of {}", values.size(),
                                points.size(), ranges.size() + 1));
  }
  const Matrix places = to_box(ranges, points);
  std::vector<std::vector<double>> effects(ranges.size());
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (i % (ranges.size() + 1) == 0) continue;  // the first of a trajectory
    const auto row = static_cast<Index>(i);
    Index moved = 0;
    (places.row(row) - places.row(row - 1)).cwiseAbs().maxCoeff(&moved);
    const double step = places(row, moved) - places(row - 1, moved);
    effects[static_cast<std::size_t>(moved)].push_back((values[i] - values[i - 1]) / step);  // (C.21)
  }
  std::vector<MorrisEffect> result;
  for (const std::vector<double>& of_one : effects) result.push_back(summary(of_one));
  return result;
}

}  // namespace repose
