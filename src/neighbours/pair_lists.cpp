#include "neighbours/pair_lists.h"

#include <algorithm>

#include "neighbours/cell_grid.h"

namespace repose {
namespace {

void set_history(ContactBlock& block, std::size_t k, const ContactHistory& h) {
  block.spring[0][k] = h.spring.x;
  block.spring[1][k] = h.spring.y;
  block.spring[2][k] = h.spring.z;
  block.rolling[0][k] = h.rolling.x;
  block.rolling[1][k] = h.rolling.y;
  block.rolling[2][k] = h.rolling.z;
}

/// Appends one lane; the rest of a new block names the two dummy particles behind the last ghost.
void append_lane(PairGroup& group, std::vector<ContactBlock>& blocks, std::size_t lane, std::size_t dummy,
                 const PairGroup::Pair& pair, const ContactHistory& history) {
  const std::size_t k = lane % block_lanes;
  if (k == 0) {
    ContactBlock& block = blocks.emplace_back();
    std::fill(std::begin(block.first), std::end(block.first), static_cast<std::int32_t>(dummy));
    std::fill(std::begin(block.second), std::end(block.second), static_cast<std::int32_t>(dummy + 1));
    for (auto& column : block.spring) std::fill(std::begin(column), std::end(column), 0.0);
    for (auto& column : block.rolling) std::fill(std::begin(column), std::end(column), 0.0);
  }
  blocks.back().first[k] = pair.first;
  blocks.back().second[k] = pair.second;
  set_history(blocks.back(), k, history);
  group.lanes = lane + 1;
}

/// The history that particle `owner` remembers of `partner`, blank when there is none.
ContactHistory remembered(const Csr<PairMemory>& memory, std::size_t owner, std::int64_t partner) {
  for (const PairMemory& m : memory.row(owner)) {
    if (m.partner == partner) return m.history;
  }
  return {};
}

std::size_t index(std::int32_t i) { return static_cast<std::size_t>(i); }

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
  return groups_.emplace_back(PairGroup{a, b, interior, {}, {}, 0});
}

void PairLists::build(const Particles& particles, std::span<const double> reach, const Csr<PairMemory>& memory) {
  groups_.clear();
  if (reach.empty()) return;
  const double smallest = *std::min_element(reach.begin(), reach.end());
  const CellGrid grid(std::span(particles.record).first(reach.size()), 2.0 * smallest);

  // The particle with the longer reach finds the pair, so that short reaches never search far.
  for (std::size_t i = 0; i < reach.size(); ++i) {
    const ParticleRecord& a = particles.record[i];
    grid.for_each_near(a.position, 2.0 * reach[i], [&](std::size_t j) {
      if (i >= particles.owned && j >= particles.owned) return;
      if (reach[j] > reach[i] || (reach[j] == reach[i] && particles.id[j] <= particles.id[i])) return;
      const double limit = reach[i] + reach[j];
      if (squared_norm(particles.record[j].position - a.position) >= limit * limit) return;

      const bool i_first = particles.id[i] < particles.id[j];
      const std::size_t first = i_first ? i : j;
      const std::size_t second = i_first ? j : i;
      PairGroup& group = group_for(particles, first, second, i < particles.owned && j < particles.owned);
      const ContactHistory history = first < particles.owned ? remembered(memory, first, particles.id[second])
                                                             : remembered(memory, second, particles.id[first]);
      PairGroup::Pair pair = {static_cast<std::int32_t>(first), static_cast<std::int32_t>(second), -1};
      if (!is_blank(history)) {
        pair.lane = static_cast<std::int32_t>(group.lanes);
        append_lane(group, group.blocks, group.lanes, particles.total(), pair, history);
      }
      group.pairs.push_back(pair);
    });
  }
}

void PairLists::select_near(const Particles& particles, const SkinRule& rule) {
  for (PairGroup& group : groups_) {
    std::vector<ContactBlock> blocks;
    blocks.reserve(group.blocks.size() + 1);
    std::size_t lane = 0;
    for (PairGroup::Pair& pair : group.pairs) {
      const ParticleRecord& a = particles.record[index(pair.first)];
      const ParticleRecord& b = particles.record[index(pair.second)];
      const double limit = reach_of(a, rule) + reach_of(b, rule);
      if (squared_norm(a.position - b.position) >= limit * limit) {
        pair.lane = -1;
        continue;
      }
      const ContactHistory history = pair.lane < 0 ? ContactHistory{} : lane_history(group, index(pair.lane));
      append_lane(group, blocks, lane, particles.total(), pair, history);
      pair.lane = static_cast<std::int32_t>(lane++);
    }
    group.lanes = lane;
    group.blocks = std::move(blocks);
  }
}

Csr<PairMemory> PairLists::memory(const Particles& particles) const {
  std::vector<std::pair<std::size_t, PairMemory>> entries;
  for (const PairGroup& group : groups_) {
    for (std::size_t lane = 0; lane < group.lanes; ++lane) {
      const ContactHistory history = lane_history(group, lane);
      if (is_blank(history)) continue;
      const std::size_t first = index(group.blocks[lane / block_lanes].first[lane % block_lanes]);
      const std::size_t second = index(group.blocks[lane / block_lanes].second[lane % block_lanes]);
      if (first < particles.owned) entries.push_back({first, {particles.id[second], history}});
      if (second < particles.owned) entries.push_back({second, {particles.id[first], history}});
    }
  }
  return Csr<PairMemory>::group(particles.owned, entries);
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

std::size_t PairLists::lanes() const {
  std::size_t count = 0;
  for (const PairGroup& g : groups_) count += g.lanes;
  return count;
}

}  // namespace repose
