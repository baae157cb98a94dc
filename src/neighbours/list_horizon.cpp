#include "neighbours/list_horizon.h"

#include <cmath>

namespace repose {
namespace {

// Measured on a falling column of 50 000 grains (docs/performance.md), in ns.
constexpr double per_particle = 500.0;  // of a rebuild, more than of an inner list alone
constexpr double per_pair = 20.0;       // of a rebuild
constexpr double per_selection = 20.0;  // of a listed pair, each time an inner list is chosen
constexpr auto steps_between_selections = static_cast<double>(ListHorizon::inner);
constexpr double worthwhile = 0.7;  // of the cost: less is gained by a shorter horizon than the estimate is good for

double cost_per_step(double particles, double pairs, std::int64_t steps) {
  return (per_particle * particles + per_pair * pairs) / static_cast<double>(steps) +
         per_selection * pairs / steps_between_selections;
}

}  // namespace

ListHorizon::Counts ListHorizon::count(const Particles& particles, double share, double dt, std::size_t listed) {
  constexpr double greatest = 1e9;  // of one particle, so that no sum wraps
  Counts counts{};
  counts[1] = static_cast<std::int64_t>(listed);
  for (std::size_t i = 0; i < particles.owned; ++i) {
    const ParticleRecord& p = particles.record[i];
    if (is_parked(p)) continue;
    ++counts[0];
    const double way = norm(p.velocity) * dt / p.radius;
    for (std::size_t k = 0; k < choices.size(); ++k) {
      const double reach = 1.0 + share + static_cast<double>(choices[k]) * way;
      counts[2 + k] += static_cast<std::int64_t>(std::fmin(reach * reach * reach, greatest));  // NaN: the greatest
    }
  }
  return counts;
}

void ListHorizon::choose(const Counts& all) {
  if (volume_ > 0.0) pairs_per_volume_ = static_cast<double>(all[1]) / volume_;
  double least = 0.0;
  for (std::size_t k = 0; k < choices.size(); ++k) {
    const double pairs = pairs_per_volume_ * static_cast<double>(all[2 + k]);
    const double cost = cost_per_step(static_cast<double>(all[0]), pairs, choices[k]);
    if (k > 0 && cost >= worthwhile * least) continue;
    least = cost;
    chosen_ = k;
  }
  volume_ = static_cast<double>(all[2 + chosen_]);
}

}  // namespace repose
