#pragma once

#include <span>
#include <vector>

#include "contact/wall_contacts.h"

namespace repose {

/// Two particles next to each other that touch or hold together; the first has the lower id.
struct TouchingPair {
  ParticleRecord first, second;  ///< copies; `first` has its force scale
  std::int32_t material_first, material_second;
  ContactHistory history;
};

/// The force in N on the first of each pair by this contact alone, from the contact law with its history as it is.
/// Each has copies of its particles for itself, so that the loop of the simulation, which adds up the forces on a
/// particle, gives that of the contact. `alarms` gets what was out of range.
std::vector<Vec3> pair_contact_forces(VectorLevel level, const MaterialTable& materials,
                                      std::span<const TouchingPair> pairs, ContactAlarms& alarms);

/// The same on the particle of each contact with a wall.
std::vector<Vec3> wall_contact_forces(VectorLevel level, std::span<const Wall> walls, const MaterialTable& materials,
                                      const Particles& particles, std::vector<WallContact> contacts,
                                      ContactAlarms& alarms);

/// The part of a vector along a direction of any length.
inline Vec3 part_along(const Vec3& vector, const Vec3& direction) {
  return (dot(vector, direction) / squared_norm(direction)) * direction;
}

}  // namespace repose
