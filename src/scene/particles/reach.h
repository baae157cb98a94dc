#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/particles/particles.h"

namespace repose {

/// Each particle has a skin of its own: a share of its radius and the way it makes within `horizon` at its present
/// speed. A list of the pairs closer than the sum of their reaches (radius, adhesion range and skin) holds every
/// contact until some particle has moved by more than its own skin. So a few fast grains make neither the lists of the
/// others long nor rebuilds frequent. Then that particle's skin can begin anew, where it is, with its pairs alone.
struct SkinRule {
  double share;                                              ///< of the radius
  double horizon;                                            ///< s
  double longest = std::numeric_limits<double>::infinity();  ///< m
  double adhesion_range = 0.0;  ///< m, how far apart surfaces that have touched may hold together; added to reaches
  double heat_share = 0.0;      ///< how far apart surfaces exchange heat, over the radius; added to reaches
};

/// Where a particle was when its skin began, and the square of that skin.
struct alignas(32) Mark {
  Vec3 position;
  double squared_skin;
};

/// Whether a particle has moved by its skin.
inline bool is_used_up(const Mark& mark, const ParticleRecord& particle) {
  return squared_norm(particle.position - mark.position) >= mark.squared_skin;
}

/// Where a particle was when its skin began, and how far from there it can be felt until the skin is used up.
struct alignas(32) ReachSphere {
  Vec3 position;
  double reach;  ///< m
};

inline bool overlap(const ReachSphere& a, const ReachSphere& b) {
  const double limit = a.reach + b.reach;
  return squared_norm(a.position - b.position) < limit * limit;
}

inline double skin_of(const ParticleRecord& particle, const SkinRule& rule) {
  return std::min(rule.share * particle.radius + rule.horizon * norm(particle.velocity), rule.longest);
}
/// The reach with a skin of `skin` m.
inline double reach_of(const ParticleRecord& particle, const SkinRule& rule, double skin) {
  return particle.radius * (1.0 + rule.heat_share) + rule.adhesion_range + skin;
}
inline double reach_of(const ParticleRecord& particle, const SkinRule& rule) {
  return reach_of(particle, rule, skin_of(particle, rule));
}

}  // namespace repose
