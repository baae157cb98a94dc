#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "comm/communicator.h"
#include "contact/wall_contacts.h"
#include "neighbours/pair_lists.h"

namespace repose {

/// A contact of two particles, or of one with a wall.
struct ListedContact {
  std::int64_t first;     ///< id, the lower one
  std::int64_t second;    ///< id; -1 at a wall
  std::int32_t wall;      ///< place in the deck; -1 between particles
  std::int32_t feature;   ///< of the wall
  Vec3 centre;            ///< m, of the first, in the domain
  Vec3 other;             ///< m, centre of the second next to it, or the touched point of the wall
  Vec3 normal_force;      ///< N, on the first
  Vec3 tangential_force;  ///< N, on the first
};

/// Collective. All contacts, in the order of their ids and walls, on rank 0; elsewhere none. Forces are of the contact
/// law at the present positions, velocities and histories, which stay as they are; the same bits on any number of
/// ranks. Velocities are those of the full step, while the time loop takes half-step ones: the dashpots differ by that.
std::vector<ListedContact> list_contacts(const Communicator& comm, VectorLevel level, std::span<const Wall> walls,
                                         const MaterialTable& materials, const Particles& particles,
                                         const PairLists& pairs, const WallContacts& wall_contacts);

}  // namespace repose
