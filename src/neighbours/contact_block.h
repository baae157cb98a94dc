#pragma once

#include <cstddef>
#include <cstdint>

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

/// The number of blocks that so many lanes take.
inline std::size_t blocks_for(std::size_t lanes) { return (lanes + block_lanes - 1) / block_lanes; }

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
