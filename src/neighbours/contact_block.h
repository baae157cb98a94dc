#pragma once

#include <cstdint>
#include <vector>

namespace repose {

inline constexpr int block_lanes = 64;

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

}  // namespace repose
