#pragma once

#include <cstdint>
#include <span>

#include "base/vector_level.h"
#include "contact/contact_alarms.h"
#include "scene/contact_memory.h"
#include "scene/materials.h"
#include "scene/particles.h"

namespace repose {

/// A particle touching a feature of a wall.
struct WallContact {
  std::int32_t particle;  ///< local index
  std::int32_t wall;
  std::int32_t feature;
  Vec3 normal;      ///< unit, from the wall to the centre
  double distance;  ///< m, from the centre to the wall
  double overlap;   ///< m
  ContactHistory history;
};

/// Evaluates the contact law on those of `contacts` that `chosen` names, all of one pair of materials, and adds forces
/// and torques to the sums of the particles. Histories advance by `dt` s. `max_overlap` is the bound as a share of the
/// radius.
ContactAlarms evaluate_walls(VectorLevel level, std::span<WallContact> contacts, std::span<const std::int32_t> chosen,
                             const PairParameters& pair, double dt, double max_overlap, const ParticleRecord* records,
                             ForceSum* sums);

}  // namespace repose
