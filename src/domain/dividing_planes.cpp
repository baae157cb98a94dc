#include "domain/dividing_planes.h"

#include <algorithm>
#include <array>
#include <limits>

#include "base/index.h"

namespace repose {
namespace {

constexpr std::size_t bins = 128;  // of each histogram
constexpr int refinements = 4;     // histograms per plane: 128^4 steps of the part's length

constexpr double places = 4096;  // along a side, so few that sums of squares of 1e10 particles do not wrap

constexpr double infinite = std::numeric_limits<double>::infinity();

/// The box about the particles of a part.
struct Bounds {
  std::array<double, 6> most;  ///< x, y, z, -x, -y, -z

  double low(int axis) const { return -most[index(axis) + 3]; }
  double length(int axis) const { return most[index(axis)] - low(axis); }
};

/// Cost along one side of a box, in integers: sums of it, of it times place and of it times the square of the place.
struct Moments {
  std::array<std::int64_t, 3> sums;

  /// Square of the standard deviation, in places.
  double variance() const {
    const auto total = static_cast<double>(sums[0]);
    const double mean = static_cast<double>(sums[1]) / total;
    return static_cast<double>(sums[2]) / total - mean * mean;
  }
};

/// Where the plane of a part is looked for: the side of its box on which its cost is spread most, then ever less of it.
struct Interval {
  int axis = 0;
  double low = 0.0;
  double width = 0.0;
  std::int64_t below = 0;   ///< cost under the interval
  std::int64_t target = 0;  ///< cost that shall lie below the plane
};

std::vector<Bounds> bounds_of(const Communicator& comm, const PartedParticles& particles, std::size_t parts) {
  std::vector<double> most(6 * parts, -infinite);
  for (std::size_t i = 0; i < particles.positions.size(); ++i) {
    if (particles.part[i] < 0) continue;
    for (int axis = 0; axis < 3; ++axis) {
      const double x = DividingPlane::along(particles.positions[i], axis);
      double* m = &most[6 * index(particles.part[i]) + index(axis)];
      m[0] = std::max(m[0], x);
      m[3] = std::max(m[3], -x);
    }
  }
  comm.max_elements(std::span(most));
  std::vector<Bounds> found(parts);
  for (std::size_t p = 0; p < parts; ++p) std::copy_n(&most[6 * p], 6, found[p].most.begin());
  return found;
}

/// For each part, along x, y and z.
std::vector<std::array<Moments, 3>> moments(const Communicator& comm, const PartedParticles& particles,
                                            std::span<const Bounds> bounds) {
  std::vector<std::int64_t> sums(9 * bounds.size(), 0);
  for (std::size_t i = 0; i < particles.positions.size(); ++i) {
    if (particles.part[i] < 0) continue;
    const std::size_t p = index(particles.part[i]);
    for (int axis = 0; axis < 3; ++axis) {
      const double length = bounds[p].length(axis);
      if (!(length > 0.0)) continue;
      const double share = (DividingPlane::along(particles.positions[i], axis) - bounds[p].low(axis)) / length;
      const auto place = static_cast<std::int64_t>(share * places);
      std::int64_t* sum = &sums[9 * p + 3 * index(axis)];
      sum[0] += particles.cost[i];
      sum[1] += particles.cost[i] * place;
      sum[2] += particles.cost[i] * place * place;
    }
  }
  comm.sum_elements(std::span(sums));
  std::vector<std::array<Moments, 3>> found(bounds.size());
  for (std::size_t p = 0; p < bounds.size(); ++p) {
    for (std::size_t axis = 0; axis < 3; ++axis) std::copy_n(&sums[9 * p + 3 * axis], 3, found[p][axis].sums.begin());
  }
  return found;
}

std::vector<Interval> sides_of_greatest_spread(std::span<const Bounds> bounds,
                                               std::span<const std::array<Moments, 3>> moments) {
  std::vector<Interval> sides(bounds.size());
  for (std::size_t p = 0; p < bounds.size(); ++p) {
    double most = -1.0;
    for (int axis = 0; axis < 3; ++axis) {
      const Moments& cost = moments[p][index(axis)];
      if (cost.sums[0] == 0) continue;  // also leaves out parts without particles
      const double length = bounds[p].length(axis);
      const double spread = cost.variance() * length * length;
      if (spread <= most) continue;
      most = spread;
      sides[p] = {axis, bounds[p].low(axis), length};
    }
  }
  return sides;
}

/// Of each interval, the cost in its bins; in the first round what lies on its upper end is in the last bin.
std::vector<std::int64_t> histograms(const Communicator& comm, const PartedParticles& particles,
                                     std::span<const Interval> intervals, bool is_first) {
  std::vector<std::int64_t> cost(bins * intervals.size(), 0);
  for (std::size_t i = 0; i < particles.positions.size(); ++i) {
    if (particles.part[i] < 0) continue;
    const std::size_t p = index(particles.part[i]);
    const Interval& interval = intervals[p];
    if (interval.width <= 0.0) continue;
    const double at = (DividingPlane::along(particles.positions[i], interval.axis) - interval.low) / interval.width;
    if (at < 0.0 || (!is_first && at >= 1.0)) continue;
    const auto bin = static_cast<std::size_t>(at * static_cast<double>(bins));
    cost[bins * p + std::min(bin, bins - 1)] += particles.cost[i];
  }
  comm.sum_elements(std::span(cost));
  return cost;
}

}  // namespace

std::vector<DividingPlane> dividing_planes(const Communicator& comm, const PartedParticles& particles,
                                           std::span<const int> ranks) {
  const std::vector<Bounds> around = bounds_of(comm, particles, ranks.size());
  std::vector<Interval> intervals = sides_of_greatest_spread(around, moments(comm, particles, around));
  for (int round = 0; round < refinements; ++round) {
    const std::vector<std::int64_t> cost = histograms(comm, particles, intervals, round == 0);
    for (std::size_t p = 0; p < ranks.size(); ++p) {
      const std::span<const std::int64_t> in_bin(&cost[bins * p], bins);
      Interval& interval = intervals[p];
      if (round == 0) {
        std::int64_t total = 0;
        for (const std::int64_t c : in_bin) total += c;
        interval.target = total * (ranks[p] / 2) / ranks[p];
      }
      std::size_t bin = 0;
      while (bin + 1 < bins && interval.below + in_bin[bin] < interval.target) interval.below += in_bin[bin++];
      interval.width /= static_cast<double>(bins);
      interval.low += static_cast<double>(bin) * interval.width;
    }
  }
  std::vector<DividingPlane> planes;
  for (const Interval& interval : intervals) planes.push_back({interval.axis, interval.low + interval.width});
  return planes;
}

}  // namespace repose
