#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "neighbours/contact_block.h"
#include "neighbours/near_pairs.h"
#include "scene/particles/contact_memory.h"
#include "scene/particles/particles.h"
#include "scene/particles/reach.h"

namespace repose {

/// The neighbour pairs of one combination of materials, which share their contact parameters. Interior groups hold
/// pairs of two owned particles; the others hold pairs with one ghost and have to wait for the ghost exchange.
struct PairGroup {
  struct Pair {
    std::int32_t first;  ///< local index of the particle with the lower id
    std::int32_t second;
    std::int32_t lane;  ///< where its history is in `blocks`, or -1
  };
  std::int32_t material_first;
  std::int32_t material_second;
  bool interior;
  BigVector<Pair> pairs;                 ///< outer list: everything within the outer reaches
  BigVector<ContactBlock> blocks;        ///< inner list: what the pair loop evaluates
  std::size_t lanes = 0;                 ///< used lanes of `blocks`
  std::vector<std::int32_t> late;        ///< pairs in the last lanes, added since the inner list was chosen
  Csr<std::int32_t> pairs_of;            ///< of each particle, in `pairs`; without rows until it is needed
  std::size_t indexed = 0;               ///< pairs in `pairs_of`; those behind, added since, are chained:
  std::vector<std::int32_t> last_added;  ///< of each particle, or -1; empty before the first
  std::vector<std::array<std::int32_t, 2>> added_before;  ///< of both particles of each, or -1
};

/// The outer and inner neighbour lists of one rank, with the histories of its pair contacts.
class PairLists {
 public:
  /// Lists the pairs and gives them the histories that the owned particles remember. The inner lists hold only those
  /// that have one afterwards.
  void build(const Particles& particles, std::span<const IndexPair> pairs, const Csr<PairMemory>& memory);

  /// Refills the inner lists with the listed pairs whose spheres, one of each particle, overlap; histories stay.
  void select_near(std::span<const ReachSphere> spheres);

  /// Lists the pairs of owned particle i with those of these other owned ones that are not listed yet. They have
  /// no histories, and are in no inner list until one is chosen or the skin of i begins anew in add_near.
  void list_more(const Particles& particles, std::int32_t i, std::span<const std::int32_t> partners);

  /// Adds to the inner lists the listed pairs of the particles `moved` whose spheres overlap by now; none is dropped.
  void add_near(std::span<const ReachSphere> spheres, std::span<const std::int32_t> moved);

  /// Forgets all pairs and histories. Their memory is kept for the next ones: where a system has to find and clear huge
  /// pages, new ones take longer than what is written there.
  void clear();

  std::span<PairGroup> groups() { return groups_; }
  std::span<const PairGroup> groups() const { return groups_; }

  /// Every history of a touching pair, with the owned particles it belongs to.
  Csr<PairMemory> memory(const Particles& particles) const;

  /// Pairs in the inner lists of each owned particle, each pair counted once on every rank: a measure of its cost.
  std::vector<std::int64_t> pairs_of_owned(const Particles& particles) const;

  std::size_t listed() const;  ///< pairs in the outer lists
  std::size_t lanes() const;   ///< pairs in the inner lists
  std::size_t bytes() const;

 private:
  void find_near(const PairGroup& group, std::span<const ReachSphere> spheres);
  void renew_lanes(PairGroup& group, std::size_t dummy);
  PairGroup& group_for(const Particles& particles, std::size_t first, std::size_t second, bool interior);

  std::vector<PairGroup> groups_;
  std::vector<std::int32_t> near_;             ///< pairs of one group, while select_near runs
  std::vector<std::int32_t> last_partner_of_;  ///< of each particle, the last whose pairs list_more looked through
};

/// Puts two dummy particles behind the last ghost, far from everything and from one another, and makes room for as many
/// force sums.
void add_lane_dummies(Particles& particles);

/// History of lane `lane` in a group's blocks.
inline ContactHistory lane_history(const PairGroup& group, std::size_t lane) {
  return history(group.blocks[lane / block_lanes], lane % block_lanes);
}

}  // namespace repose
