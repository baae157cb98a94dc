#pragma once

#include <cstdint>
#include <span>

#include "base/big_vector.h"
#include "base/vector_level.h"
#include "contact/contact_alarms.h"
#include "neighbours/contact_block.h"
#include "scene/particles/contact_memory.h"
#include "scene/particles/materials.h"
#include "scene/particles/particles.h"
#include "scene/walls/wall.h"

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

/// What the contacts of one material with one wall have in common.
struct WallLaw {
  PairParameters pair;
  double dt;                               ///< s, by which histories advance
  double max_overlap;                      ///< bound, as a share of the radius
  const Placement* placement = nullptr;    ///< where the wall is; null: where it is in the deck
  const SurfaceMotion* surface = nullptr;  ///< of the wall; null: it rests
};

/// Evaluates the contact law on those of `contacts` that `chosen` names, all of one material with one wall, and adds
/// forces and torques to the sums of the particles.
ContactAlarms evaluate_walls(VectorLevel level, const WallLaw& law, std::span<WallContact> contacts,
                             std::span<const std::int32_t> chosen, const ParticleRecord* records, ForceSum* sums);

/// The law of particles of `material` at a wall. Points into the wall.
inline WallLaw wall_law(const MaterialTable& materials, std::int32_t material, const Wall& wall, double dt,
                        double max_overlap) {
  return {materials.pair(static_cast<std::size_t>(material), static_cast<std::size_t>(wall.material)), dt, max_overlap,
          wall.travels ? &wall.placement : nullptr, wall.moves() ? &wall.placement.motion : nullptr};
}

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
ContactAlarms evaluate_faces(VectorLevel level, const WallLaw& law, FaceGroup& group, const ParticleRecord* records,
                             ForceSum* sums);

}  // namespace repose
