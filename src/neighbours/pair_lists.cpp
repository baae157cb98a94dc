#include "neighbours/pair_lists.h"

namespace repose {
namespace {

std::size_t index(std::int32_t i) { return static_cast<std::size_t>(i); }

ContactHistory history_of(const PairGroup& group, const PairGroup::Pair& pair) {
  return pair.lane < 0 ? ContactHistory{} : lane_history(group, static_cast<std::size_t>(pair.lane));
}

void set_lane(ContactBlock& block, std::size_t k, std::int32_t first, std::int32_t second, const ContactHistory& h) {
  block.first[k] = first;
  block.second[k] = second;
  set_history(block, k, h);
}

/// Fills the rest of the last block with the two dummy particles behind the last ghost.
void fill_tail(BigVector<ContactBlock>& blocks, std::size_t lanes, std::size_t dummy) {
  for (std::size_t lane = lanes; lane < block_lanes * blocks.size(); ++lane) {
    set_lane(blocks.back(), lane % block_lanes, static_cast<std::int32_t>(dummy), static_cast<std::int32_t>(dummy + 1),
             {});
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
  return groups_.emplace_back(PairGroup{
      .material_first = a, .material_second = b, .interior = interior, .pairs = {}, .blocks = {}, .fetch = {}});
}

void PairLists::build(const Particles& particles, std::span<const IndexPair> pairs, const Csr<PairMemory>& memory) {
  groups_.clear();
  for (const auto& [i, j] : pairs) {
    const bool i_first = particles.id[index(i)] < particles.id[index(j)];
    const std::int32_t first = i_first ? i : j;
    const std::int32_t second = i_first ? j : i;
    PairGroup& group = group_for(particles, index(first), index(second), index(j) < particles.owned);
    // i, the lower index, is owned.
    const ContactHistory history = remembered(memory, index(i), particles.id[index(j)]);
    PairGroup::Pair pair = {first, second, -1};
    if (!is_blank(history)) {
      if (group.lanes % block_lanes == 0) group.blocks.emplace_back();
      set_lane(group.blocks.back(), group.lanes % block_lanes, first, second, history);
      pair.lane = static_cast<std::int32_t>(group.lanes++);
    }
    group.pairs.push_back(pair);
  }
}

void PairLists::select_near(const Particles& particles, const SkinRule& rule) {
  reach_.resize(particles.total());
  for (std::size_t i = 0; i < reach_.size(); ++i) reach_[i] = reach_of(particles.record[i], rule);
  for (PairGroup& group : groups_) {
    find_near(particles, group);
    blocks_.resize((near_.size() + block_lanes - 1) / block_lanes);
    std::size_t next = 0;
    for (std::size_t lane = 0; lane < near_.size(); ++lane, ++next) {
      for (; next < index(near_[lane]); ++next) group.pairs[next].lane = -1;
      PairGroup::Pair& pair = group.pairs[next];
      set_lane(blocks_[lane / block_lanes], lane % block_lanes, pair.first, pair.second, history_of(group, pair));
      pair.lane = static_cast<std::int32_t>(lane);
    }
    for (; next < group.pairs.size(); ++next) group.pairs[next].lane = -1;
    fill_tail(blocks_, near_.size(), particles.total());
    std::swap(group.blocks, blocks_);
    group.lanes = near_.size();
    list_fetches(particles, group);
  }
}

void PairLists::list_fetches(const Particles& particles, PairGroup& group) {
  constexpr std::uint32_t memory = 128;  // blocks whose particles are still in the second-level cache
  used_.assign(particles.total() + 2, 0);
  group.fetch.items.clear();
  group.fetch.offset.assign(1, 0);
  for (std::uint32_t b = 0; b < group.blocks.size(); ++b) {
    for (const auto* side : {group.blocks[b].first, group.blocks[b].second}) {
      for (int k = 0; k < block_lanes; ++k) {
        std::uint32_t& used = used_[index(side[k])];
        if (used == 0 || b + 1 > used + memory) group.fetch.items.push_back(side[k]);
        used = b + 1;
      }
    }
    group.fetch.offset.push_back(group.fetch.items.size());
  }
}

/// The pairs of a group that are closer than the sum of their reaches, by a loop without branches: which they are is
/// hard to foresee.
void PairLists::find_near(const Particles& particles, const PairGroup& group) {
  near_.resize(group.pairs.size() + 1);
  std::size_t count = 0;
  for (std::size_t p = 0; p < group.pairs.size(); ++p) {
    const std::size_t a = index(group.pairs[p].first);
    const std::size_t b = index(group.pairs[p].second);
    const double limit = reach_[a] + reach_[b];
    near_[count] = static_cast<std::int32_t>(p);
    count += squared_norm(particles.record[a].position - particles.record[b].position) < limit * limit ? 1U : 0U;
  }
  near_.resize(count);
}

Csr<PairMemory> PairLists::memory(const Particles& particles) const {
  return Csr<PairMemory>::group(particles.owned, [&](const auto& add) {
    for (const PairGroup& group : groups_) {
      for (std::size_t lane = 0; lane < group.lanes; ++lane) {
        const ContactHistory history = lane_history(group, lane);
        if (is_blank(history)) continue;
        const std::size_t first = index(group.blocks[lane / block_lanes].first[lane % block_lanes]);
        const std::size_t second = index(group.blocks[lane / block_lanes].second[lane % block_lanes]);
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
  for (const PairGroup& g : groups_)
    count += bytes_of(g.pairs) + bytes_of(g.blocks) + bytes_of(g.fetch.items) + bytes_of(g.fetch.offset);
  return count + bytes_of(used_) + bytes_of(reach_) + bytes_of(near_) + bytes_of(blocks_);
}

std::size_t PairLists::lanes() const {
  std::size_t count = 0;
  for (const PairGroup& g : groups_) count += g.lanes;
  return count;
}

}  // namespace repose
