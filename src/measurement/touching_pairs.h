#pragma once

#include "neighbours/pair_lists.h"

namespace repose {

/// Calls visit(group, first, second, overlap, lane) for every touching pair that counts here: the rank that owns the
/// lower id counts it. What remembers at a negative overlap is held together by adhesion.
template <class Visit>
void for_each_touching_pair(const Particles& particles, const PairLists& pairs, Visit&& visit) {
  for (const PairGroup& group : pairs.groups()) {
    for (const PairGroup::Pair& pair : group.pairs) {
      const auto i = static_cast<std::size_t>(pair.first);
      const auto j = static_cast<std::size_t>(pair.second);
      if (pair.lane < 0 || i >= particles.owned) continue;
      const ParticleRecord& a = particles.record[i];
      const ParticleRecord& b = particles.record[j];
      const double overlap = a.radius + b.radius - norm(a.position - b.position);
      const auto lane = static_cast<std::size_t>(pair.lane);
      if (overlap > 0.0 || !is_blank(lane_history(group, lane))) visit(group, i, j, overlap, lane);
    }
  }
}

}  // namespace repose
