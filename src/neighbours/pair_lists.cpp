#include "neighbours/pair_lists.h"

#include <algorithm>

#include "base/index.h"

namespace repose {
namespace {

ContactHistory history_of(const PairGroup& group, const PairGroup::Pair& pair) {
  return pair.lane < 0 ? ContactHistory{} : lane_history(group, static_cast<std::size_t>(pair.lane));
}

void set_lane(BigVector<ContactBlock>& blocks, std::size_t lane, std::int32_t first, std::int32_t second,
              const ContactHistory& h) {
  ContactBlock& block = blocks[lane / block_lanes];
  const std::size_t slot = lane % block_lanes;
  block.first[slot] = first;
  block.second[slot] = second;
  set_history(block, slot, h);
}

/// Fills the rest of the last block with the two dummy particles behind the last ghost.
void fill_tail(BigVector<ContactBlock>& blocks, std::size_t lanes, std::size_t dummy) {
  for (std::size_t lane = lanes; lane < block_lanes * blocks.size(); ++lane) {
    set_lane(blocks, lane, static_cast<std::int32_t>(dummy), static_cast<std::int32_t>(dummy + 1), {});
  }
}

bool are_near(const PairGroup::Pair& pair, std::span<const ReachSphere> spheres) {
  return overlap(spheres[index(pair.first)], spheres[index(pair.second)]);
}

Csr<std::int32_t> pairs_by_particle(std::span<const PairGroup::Pair> pairs, std::size_t particles) {
  return Csr<std::int32_t>::group(particles, [&](const auto& add) {
    for (std::size_t p = 0; p < pairs.size(); ++p) {
      add(index(pairs[p].first), static_cast<std::int32_t>(p));
      add(index(pairs[p].second), static_cast<std::int32_t>(p));
    }
  });
}

/// Prepares a group for for_each_pair_of.
void index_pairs(PairGroup& group, std::size_t particles) {
  if (group.pairs_of.rows() > 0) return;
  group.pairs_of = pairs_by_particle(group.pairs, particles);
  group.indexed = group.pairs.size();
}

/// Calls visit(number) for each pair of particle i in a group.
template <class Visit>
void for_each_pair_of(const PairGroup& group, std::int32_t i, Visit&& visit) {
  for (const std::int32_t p : group.pairs_of.row(index(i))) visit(p);
  if (group.last_added.empty()) return;
  for (std::int32_t p = group.last_added[index(i)]; p >= 0;) {
    visit(p);
    p = group.added_before[index(p) - group.indexed][group.pairs[index(p)].first == i ? 0 : 1];
  }
}

/// Puts a pair behind those of a group that index_pairs has seen.
void add_pair(PairGroup& group, const PairGroup::Pair& pair, std::size_t particles) {
  group.last_added.resize(particles, -1);
  const auto number = static_cast<std::int32_t>(group.pairs.size());
  group.pairs.push_back(pair);
  std::int32_t& first = group.last_added[index(pair.first)];
  std::int32_t& second = group.last_added[index(pair.second)];
  group.added_before.push_back({first, second});
  first = second = number;
}

/// The history that particle `owner` remembers of `partner`, blank when there is none.
ContactHistory remembered(const Csr<PairMemory>& memory, std::size_t owner, std::int64_t partner) {
  for (const PairMemory& m : memory.row(owner)) {
    if (m.partner == partner) return m.history;
  }
  return {};
}

}  // namespace

void add_lane_dummies(Particles& particles) {
  for (const double x : {-1.0, -2.0}) {
    ParticleRecord dummy = {};
    dummy.position = {x * parking_distance, 0.0, 0.0};
    dummy.radius = 1.0;
    particles.record.push_back(dummy);
  }
  particles.sum.assign(particles.record.size(), ForceSum{});
}

PairGroup& PairLists::group_for(const Particles& particles, std::size_t first, std::size_t second, bool interior) {
  const std::int32_t a = particles.material[first];
  const std::int32_t b = particles.material[second];
  for (PairGroup& g : groups_) {
    if (g.material_first == a && g.material_second == b && g.interior == interior) return g;
  }
  return groups_.emplace_back(PairGroup{.material_first = a,
                                        .material_second = b,
                                        .interior = interior,
                                        .pairs = {},
                                        .blocks = {},
                                        .late = {},
                                        .pairs_of = {},
                                        .last_added = {},
                                        .added_before = {}});
}

void PairLists::clear() {
  last_partner_of_.clear();
  for (PairGroup& group : groups_) {
    group.pairs.clear();
    group.blocks.clear();
    group.lanes = 0;
    group.late.clear();
    group.pairs_of = {};
    group.last_added.clear();
    group.added_before.clear();
  }
}

void PairLists::build(const Particles& particles, std::span<const IndexPair> pairs, const Csr<PairMemory>& memory) {
  clear();
  for (const auto& [i, j] : pairs) {
    const bool i_first = particles.id[index(i)] < particles.id[index(j)];
    const std::int32_t first = i_first ? i : j;
    const std::int32_t second = i_first ? j : i;
    PairGroup& group = group_for(particles, index(first), index(second), index(j) < particles.owned);
    // i, the lower index, is owned.
    const ContactHistory history = remembered(memory, index(i), particles.id[index(j)]);
    PairGroup::Pair pair = {first, second, -1};
    if (!is_blank(history)) {
      pair.lane = static_cast<std::int32_t>(group.lanes++);
      group.blocks.resize(blocks_for(group.lanes));
      set_lane(group.blocks, group.lanes - 1, first, second, history);
    }
    group.pairs.push_back(pair);
  }
  std::erase_if(groups_, [](const PairGroup& group) { return group.pairs.empty(); });
}

void PairLists::select_near(std::span<const ReachSphere> spheres) {
  for (PairGroup& group : groups_) {
    find_near(group, spheres);
    renew_lanes(group, spheres.size());
  }
}

/// The pairs of a group whose spheres overlap, by a loop without branches: which they are is hard to foresee.
void PairLists::find_near(const PairGroup& group, std::span<const ReachSphere> spheres) {
  near_.resize(group.pairs.size() + 1);
  std::size_t count = 0;
  for (std::size_t p = 0; p < group.pairs.size(); ++p) {
    near_[count] = static_cast<std::int32_t>(p);
    count += are_near(group.pairs[p], spheres) ? 1U : 0U;
  }
  near_.resize(count);
}

void PairLists::list_more(const Particles& particles, std::int32_t i, std::span<const std::int32_t> partners) {
  last_partner_of_.resize(particles.total(), -1);
  for (PairGroup& group : groups_) {
    index_pairs(group, particles.total());
    for_each_pair_of(group, i, [&](std::int32_t p) {
      const PairGroup::Pair& pair = group.pairs[index(p)];
      last_partner_of_[index(pair.first == i ? pair.second : pair.first)] = i;
    });
  }
  for (const std::int32_t j : partners) {
    if (last_partner_of_[index(j)] == i) continue;
    const bool i_first = particles.id[index(i)] < particles.id[index(j)];
    const std::int32_t first = i_first ? i : j;
    const std::int32_t second = i_first ? j : i;
    PairGroup& group = group_for(particles, index(first), index(second), true);
    index_pairs(group, particles.total());
    add_pair(group, {first, second, -1}, particles.total());
  }
}

void PairLists::add_near(std::span<const ReachSphere> spheres, std::span<const std::int32_t> moved) {
  if (moved.empty()) return;
  for (PairGroup& group : groups_) {
    index_pairs(group, spheres.size());
    for (const std::int32_t i : moved) {
      for_each_pair_of(group, i, [&](std::int32_t p) {
        PairGroup::Pair& pair = group.pairs[index(p)];
        if (pair.lane >= 0 || !are_near(pair, spheres)) return;
        pair.lane = static_cast<std::int32_t>(group.lanes++);
        if (blocks_for(group.lanes) > group.blocks.size()) {
          group.blocks.emplace_back();
          fill_tail(group.blocks, group.lanes, spheres.size());
        }
        set_lane(group.blocks, index(pair.lane), pair.first, pair.second, {});
        group.late.push_back(p);
      });
    }
  }
}

/// Gives the near pairs of a group the first lanes, in their order, with their histories. In place: as the old lanes
/// follow the same order, but for the late ones, which are taken out first, no lane is overwritten whose history is
/// still needed, when those that move down do so from the first on and then those that move up or are new from the last
/// on.
void PairLists::renew_lanes(PairGroup& group, std::size_t dummy) {
  std::vector<ContactHistory> of_late;
  of_late.reserve(group.late.size());
  for (const std::int32_t p : group.late) {
    of_late.push_back(history_of(group, group.pairs[index(p)]));
    group.pairs[index(p)].lane = -1;
  }
  const std::size_t blocks = blocks_for(near_.size());
  if (blocks > group.blocks.capacity()) group.blocks.reserve(blocks + blocks / 8);
  group.blocks.resize(std::max(blocks, group.blocks.size()));
  const auto move_to = [&](std::size_t lane, PairGroup::Pair& pair) {
    const ContactHistory history = history_of(group, pair);
    set_lane(group.blocks, lane, pair.first, pair.second, history);
    pair.lane = static_cast<std::int32_t>(lane);
  };
  std::size_t next = 0;
  for (std::size_t lane = 0; lane < near_.size(); ++lane, ++next) {
    for (; next < index(near_[lane]); ++next) group.pairs[next].lane = -1;
    if (group.pairs[next].lane > static_cast<std::int32_t>(lane)) move_to(lane, group.pairs[next]);
  }
  for (; next < group.pairs.size(); ++next) group.pairs[next].lane = -1;
  for (std::size_t lane = near_.size(); lane-- > 0;) {
    PairGroup::Pair& pair = group.pairs[index(near_[lane])];
    if (pair.lane != static_cast<std::int32_t>(lane)) move_to(lane, pair);
  }
  group.blocks.resize(blocks);
  group.lanes = near_.size();
  fill_tail(group.blocks, group.lanes, dummy);
  for (std::size_t k = 0; k < of_late.size(); ++k) {
    const std::int32_t lane = group.pairs[index(group.late[k])].lane;
    if (lane >= 0) set_history(group.blocks[index(lane) / block_lanes], index(lane) % block_lanes, of_late[k]);
  }
  group.late.clear();
}

Csr<PairMemory> PairLists::memory(const Particles& particles) const {
  return Csr<PairMemory>::group(particles.owned, [&](const auto& add) {
    for (const PairGroup& group : groups_) {
      for (std::size_t lane = 0; lane < group.lanes; ++lane) {
        const ContactHistory history = lane_history(group, lane);
        if (is_blank(history)) continue;
        const ContactBlock& block = group.blocks[lane / block_lanes];
        const std::size_t first = index(block.first[lane % block_lanes]);
        const std::size_t second = index(block.second[lane % block_lanes]);
        if (first < particles.owned) add(first, {particles.id[second], history});
        if (second < particles.owned) add(second, {particles.id[first], history});
      }
    }
  });
}

std::vector<std::int64_t> PairLists::pairs_of_owned(const Particles& particles) const {
  std::vector<std::int64_t> count(particles.owned, 0);
  for (const PairGroup& group : groups_) {
    for (const PairGroup::Pair& pair : group.pairs) {
      if (pair.lane < 0) continue;
      ++count[index(pair.first) < particles.owned ? index(pair.first) : index(pair.second)];
    }
  }
  return count;
}

std::size_t PairLists::listed() const {
  std::size_t count = 0;
  for (const PairGroup& g : groups_) count += g.pairs.size();
  return count;
}

std::size_t PairLists::bytes() const {
  std::size_t count = 0;
  for (const PairGroup& g : groups_) {
    count += bytes_of(g.pairs) + bytes_of(g.blocks) + bytes_of(g.late) + bytes_of(g.pairs_of.offset) +
             bytes_of(g.pairs_of.items) + bytes_of(g.last_added) + bytes_of(g.added_before);
  }
  return count + bytes_of(near_) + bytes_of(last_partner_of_);
}

std::size_t PairLists::lanes() const {
  std::size_t count = 0;
  for (const PairGroup& g : groups_) count += g.lanes;
  return count;
}

}  // namespace repose
