#pragma once

#include "scene/particles/particles.h"

namespace repose {

/// s, by which springs go on before a contact is looked at: one that slides is at Coulomb's limit, and has no dashpot
/// once it has gone on beyond it, by however little; what sticks is not to notice it.
inline constexpr double moment = 1e-12;

/// N, that a sum of contacts with a particle holds.
inline Vec3 force_of(const ForceSum& sum, const ParticleRecord& p) {
  return {static_cast<double>(sum.force[0]) / p.force_scale, static_cast<double>(sum.force[1]) / p.force_scale,
          static_cast<double>(sum.force[2]) / p.force_scale};
}

/// N m, about the particle's centre.
inline Vec3 torque_of(const ForceSum& sum, const ParticleRecord& p) {
  return {static_cast<double>(sum.torque[0]) / p.torque_scale, static_cast<double>(sum.torque[1]) / p.torque_scale,
          static_cast<double>(sum.torque[2]) / p.torque_scale};
}

}  // namespace repose
