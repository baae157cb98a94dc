#pragma once

#include "base/math.h"
#include "contact/geometry.h"
#include "scene/particles/materials.h"

// Cohesion by an energy density k (Pa) times the area in which the undeformed bodies cut one another (SJKR) or, for
// SJKR2, an area linear in the overlap, as in LIGGGHTS 3.8: docs/theory.md, "Cohesion". It acts while they overlap.

namespace repose {

/// m2, of two spheres of radii `a` and `b` m whose centres are `distance` m apart; 0 without overlap.
template <class Real>
[[gnu::always_inline]] inline Real cohesive_area_of_spheres(const PairParameters& pair, const Real& a, const Real& b,
                                                            const Real& distance, const Real& overlap) {
  if (pair.options.cohesion == Cohesion::none || pair.options.cohesion == Cohesion::capillary) return Real{};
  if (pair.options.cohesion == Cohesion::sjkr2) return (4.0 * pi) * (a * b / (a + b)) * overlap;
  const Real product = overlap * (distance + a - b) * (distance - a + b) * (distance + a + b);
  return (0.25 * pi) * product / (distance * distance);
}

/// The same of a sphere of `radius` m and a wall.
template <class Real>
[[gnu::always_inline]] inline Real cohesive_area_at_wall(const PairParameters& pair, const Real& radius,
                                                         const Real& distance, const Real& overlap) {
  if (pair.options.cohesion == Cohesion::none || pair.options.cohesion == Cohesion::capillary) return Real{};
  if (pair.options.cohesion == Cohesion::sjkr2) return (2.0 * pi) * radius * overlap;
  return pi * overlap * (radius + distance);
}

}  // namespace repose
