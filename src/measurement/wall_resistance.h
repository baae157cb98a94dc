#pragma once

#include <span>

#include "comm/communicator.h"
#include "contact/wall_contacts.h"

namespace repose {

/// A wall that could move along its servo's axis, or turn about it.
struct PressingWall {
  std::int32_t wall;   ///< its place among all
  double interval;     ///< s, until the next look
  double max_overlap;  ///< share of the radius that ends a run; the wall is tried no deeper than twice that
};

/// Collective. The grains' force along its axis, or torque about it, on a wall with a servo and on those that move with
/// it, and what this would grow by if the wall moved at the servo's greatest speed for the interval while the grains
/// stayed where they are: overlaps, tangential springs and dashpots by the contact law. Nothing changes; the same bits
/// on any number of ranks.
WallResistance measure_resistance(const Communicator& comm, VectorLevel level, const PressingWall& pressing,
                                  std::span<const Wall> walls, const MaterialTable& materials,
                                  const Particles& particles, const WallContacts& wall_contacts);

}  // namespace repose
