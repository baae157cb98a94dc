#pragma once

#include <map>
#include <utility>

#include "neighbours/pair_lists.h"
#include "support/draw.h"

namespace repose::test {

struct CloudOptions {
  std::size_t count = 600;
  double smallest = 1e-3;  ///< m
  double largest = 1e-3;   ///< m
  double box = 0.02;       ///< m, edge of the cube that holds all centres
  double speed = 0.05;     ///< m/s, greatest component; 0 gives grains of one size the same reach
  double fast_share = 0.0;
  double fast_speed = 50.0;  ///< m/s
};

/// Random grains in a cube; the first two thirds are owned, the rest are ghosts. Ids are in no order; two materials.
inline Particles random_cloud(std::uint64_t seed, const CloudOptions& options) {
  Draw draw(seed);
  Particles p;
  for (std::size_t i = 0; i < options.count; ++i) {
    ParticleRecord record = {};
    record.position = draw.vector(0.5 * options.box);
    record.radius = draw(options.smallest, options.largest);
    const bool fast = draw(0.0, 1.0) < options.fast_share;
    record.velocity = draw.vector(fast ? options.fast_speed : options.speed);
    p.record.push_back(record);
    p.id.push_back(static_cast<std::int64_t>((7919 * i + 13) % 1000003));
    p.material.push_back(static_cast<std::int32_t>(draw.below(2)));
  }
  p.owned = 2 * options.count / 3;
  add_lane_dummies(p);
  return p;
}

inline std::vector<double> reaches(const Particles& p, const SkinRule& rule) {
  std::vector<double> reach(p.total());
  for (std::size_t i = 0; i < reach.size(); ++i) reach[i] = reach_of(p.record[i], rule);
  return reach;
}

inline std::vector<ReachSphere> spheres(const Particles& p, const SkinRule& rule) {
  std::vector<ReachSphere> spheres(p.total());
  for (std::size_t i = 0; i < spheres.size(); ++i) spheres[i] = {p.record[i].position, reach_of(p.record[i], rule)};
  return spheres;
}

inline std::vector<IndexPair> listed(const Particles& p, const SkinRule& rule) {
  return near_pairs(std::span(p.record).first(p.total()), reaches(p, rule), p.owned);
}

using IdPair = std::pair<std::int64_t, std::int64_t>;

/// How often each pair of ids (the lower first) occurs.
using PairCount = std::map<IdPair, int>;

/// All pairs with an owned particle that are closer than the sum of their reaches.
inline PairCount brute_force(const Particles& p, const SkinRule& rule) {
  PairCount pairs;
  for (std::size_t i = 0; i < p.total(); ++i) {
    for (std::size_t j = i + 1; j < p.total(); ++j) {
      const double limit = reach_of(p.record[i], rule) + reach_of(p.record[j], rule);
      if (i >= p.owned || squared_norm(p.record[i].position - p.record[j].position) >= limit * limit) continue;
      pairs[std::minmax(p.id[i], p.id[j])] = 1;
    }
  }
  return pairs;
}

inline IdPair ids(const Particles& p, std::int32_t first, std::int32_t second) {
  return {p.id[static_cast<std::size_t>(first)], p.id[static_cast<std::size_t>(second)]};
}

inline PairCount outer_pairs(const Particles& p, const PairLists& lists) {
  PairCount pairs;
  for (const PairGroup& group : lists.groups()) {
    for (const PairGroup::Pair& pair : group.pairs) ++pairs[ids(p, pair.first, pair.second)];
  }
  return pairs;
}

inline PairCount inner_pairs(const Particles& p, const PairLists& lists) {
  PairCount pairs;
  for (const PairGroup& group : lists.groups()) {
    for (std::size_t lane = 0; lane < group.lanes; ++lane) {
      const std::size_t block = lane / block_lanes;
      const std::size_t slot = lane % block_lanes;
      ++pairs[ids(p, group.blocks[block].first[slot], group.blocks[block].second[slot])];
    }
  }
  return pairs;
}

}  // namespace repose::test
