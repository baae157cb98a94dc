#pragma once

#include <cstdint>
#include <span>

#include "base/big_vector.h"
#include "base/vector_level.h"
#include "contact/contact_alarms.h"
#include "neighbours/contact_block.h"
#include "scene/contact_memory.h"
#include "scene/materials.h"
#include "scene/particles.h"
#include "scene/wall_face.h"

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

/// Particles of one material near one face of a wall, and no other feature, in blocks whose second particles mean
/// nothing. The rules for lanes are those of neighbour pairs: what does not touch holds zero history.
struct FaceGroup {
  std::int32_t material;
  std::int32_t wall;
  std::int32_t feature;
  Face face;
  BigVector<ContactBlock> blocks;
  std::size_t lanes = 0;  ///< used ones; those behind them in the last block repeat its first particle
};

/// The same for all lanes of a group.
ContactAlarms evaluate_faces(VectorLevel level, FaceGroup& group, const PairParameters& pair, double dt,
                             double max_overlap, const ParticleRecord* records, ForceSum* sums);

}  // namespace repose
