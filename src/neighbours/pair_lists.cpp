#include "neighbours/pair_lists.h"

#include <algorithm>

namespace repose {
namespace {

std::size_t index(std::int32_t i) { return static_cast<std::size_t>(i); }

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
  return groups_.emplace_back(
      PairGroup{.material_first = a, .material_second = b, .interior = interior, .pairs = {}, .blocks = {}});
}

void PairLists::clear() {
  for (PairGroup& group : groups_) {
    group.pairs.clear();
    group.blocks.clear();
    group.lanes = 0;
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

void PairLists::select_near(const Particles& particles, const SkinRule& rule) {
  spheres_.resize(particles.total());
  for (std::size_t i = 0; i < spheres_.size(); ++i) {
    spheres_[i] = {particles.record[i].position, reach_of(particles.record[i], rule)};
  }
  for (PairGroup& group : groups_) {
    find_near(group);
    renew_lanes(group, particles.total());
  }
}

/// The pairs of a group that are closer than the sum of their reaches, by a loop without branches: which they are is
/// hard to foresee.
void PairLists::find_near(const PairGroup& group) {
  near_.resize(group.pairs.size() + 1);
  std::size_t count = 0;
  for (std::size_t p = 0; p < group.pairs.size(); ++p) {
    const ReachSphere& a = spheres_[index(group.pairs[p].first)];
    const ReachSphere& b = spheres_[index(group.pairs[p].second)];
    const double limit = a.reach + b.reach;
    near_[count] = static_cast<std::int32_t>(p);
    count += squared_norm(a.position - b.position) < limit * limit ? 1U : 0U;
  }
  near_.resize(count);
}

/// Gives the near pairs of a group the first lanes, in their order, with their histories. In place: as the old lanes
/// follow the same order, no lane is overwritten whose history is still needed, when those that move down do so from
/// the first on and then those that move up or are new from the last on.
void PairLists::renew_lanes(PairGroup& group, std::size_t dummy) {
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
  for (const PairGroup& g : groups_) count += bytes_of(g.pairs) + bytes_of(g.blocks);
  return count + bytes_of(spheres_) + bytes_of(near_);
}

std::size_t PairLists::lanes() const {
  std::size_t count = 0;
  for (const PairGroup& g : groups_) count += g.lanes;
  return count;
}

}  // namespace repose
