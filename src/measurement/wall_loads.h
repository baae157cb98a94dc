#pragma once

#include <span>
#include <vector>

#include "comm/communicator.h"
#include "contact/wall_contacts.h"

namespace repose {

/// What all particles together exert on a wall.
struct WallLoad {
  Vec3 force;   ///< N
  Vec3 torque;  ///< N m, about the origin of coordinates
};

/// N m, about the axis through `origin` (m) along `axis` (unit).
inline double torque_about(const WallLoad& load, const Vec3& origin, const Vec3& axis) {
  return dot(axis, load.torque - cross(origin, load.force));
}

/// Collective. The load on each wall, from the contact law at the present positions, velocities and histories, which
/// stay as they are; the same bits on any number of ranks. Velocities are those of the full step, while the time loop
/// takes half-step ones: the dashpots differ by that.
std::vector<WallLoad> measure_wall_loads(const Communicator& comm, VectorLevel level, std::span<const Wall> walls,
                                         const MaterialTable& materials, const Particles& particles,
                                         const WallContacts& wall_contacts);

}  // namespace repose
