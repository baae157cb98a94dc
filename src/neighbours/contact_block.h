#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/csr.h"
#include "scene/particles/contact_memory.h"

namespace repose {

inline constexpr int block_lanes = 16;

/// A run of neighbour pairs and what their contacts remember, laid out for vector registers. `first` has the lower id;
/// all vectors of a contact point from the second to the first. Lanes that are not in contact hold zero history, so
/// that which pairs are listed never matters to the result. Unused lanes of the last block name two far-away dummy
/// particles.
struct alignas(64) ContactBlock {
  std::int32_t first[block_lanes];
  std::int32_t second[block_lanes];
  double spring[3][block_lanes];   ///< m
  double rolling[3][block_lanes];  ///< N m
};

/// For each block of a run the particles that no block shortly before it uses: the pair loop would have to wait for
/// their records and sums, if they were not asked for ahead.
using FetchList = Csr<std::int32_t>;

/// The part of a fetch list that begins with some block; without a list nothing is fetched ahead.
struct FetchView {
  const FetchList* list = nullptr;
  std::size_t first_block = 0;

  std::span<const std::int32_t> of_block(std::size_t block) const {
    if (list == nullptr) return {};
    return list->row(first_block + block);
  }
};

/// Where a lane of a pair list lies. Lanes are dealt to four blocks in turn: neighbours in a list often share a
/// particle, and in one block each would have to wait until the one before it has written that particle's sums.
struct LanePlace {
  std::size_t block, slot;
};
inline constexpr std::size_t dealt_blocks = 4;
inline constexpr std::size_t dealt_lanes = dealt_blocks * block_lanes;
inline LanePlace place_of(std::size_t lane) {
  return {lane / dealt_lanes * dealt_blocks + lane % dealt_blocks, lane % dealt_lanes / dealt_blocks};
}
/// The number of blocks that `lanes` lanes of a pair list take.
inline std::size_t blocks_for(std::size_t lanes) { return (lanes + dealt_lanes - 1) / dealt_lanes * dealt_blocks; }

inline ContactHistory history(const ContactBlock& b, std::size_t k) {
  return {{b.spring[0][k], b.spring[1][k], b.spring[2][k]}, {b.rolling[0][k], b.rolling[1][k], b.rolling[2][k]}};
}
inline void set_history(ContactBlock& b, std::size_t k, const ContactHistory& h) {
  b.spring[0][k] = h.spring.x;
  b.spring[1][k] = h.spring.y;
  b.spring[2][k] = h.spring.z;
  b.rolling[0][k] = h.rolling.x;
  b.rolling[1][k] = h.rolling.y;
  b.rolling[2][k] = h.rolling.z;
}

}  // namespace repose
