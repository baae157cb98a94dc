#pragma once

#include <cstdint>
#include <span>

#include "base/vector_level.h"
#include "scene/particles/particles.h"
#include "scene/particles/reach.h"

namespace repose {

class MaterialTable;
struct DomainDeck;

/// The share of its radius that a particle must not move by in one step. Whatever comes to pass a wall or a particle
/// that moves by as much then overlaps with it after some step by more than any `guards.max_overlap`, which is at most
/// 0.5: the strip about a surface in which a centre is that near is 2 (1 - 0.5) radii wide.
inline constexpr double longest_way = 0.5;

/// What the first half of a step has noticed on its way over the particles.
struct StepNotes {
  std::size_t outside = 0;    ///< particles that are not within the domain, parked ones too
  std::size_t moved = 0;      ///< particles that have moved by their skin since they were marked
  bool nowhere = false;       ///< some position is NaN
  double longest_step = 0.0;  ///< m, the longest that any particle has moved in this step along x, y or z
};

/// Velocity Verlet with forces from half-step velocities: first half v += a dt/2, x += v dt, then the forces, then
/// second half v += a dt/2; the same for the spins. `gravity` in m/s2, `dt` in s. Owned particles only. The first half
/// leaves all force sums at zero, ready for the contacts; `marks` are one per owned particle, and of those that have
/// moved by their skin the indices come first in `moved`, which has room for as many. `domain` is without bounds in the
/// periodic directions of the particles (Periodicity::open_bounds).
StepNotes step_first_half(VectorLevel level, const Vec3& gravity, double dt, const DomainDeck& domain,
                          std::span<const Mark> marks, std::span<std::int32_t> moved, Particles& particles);
void step_second_half(VectorLevel level, const Vec3& gravity, double dt, Particles& particles);

/// The second half of a step and the first half of the next in one pass over the particles; the same bits.
StepNotes step_second_and_first_half(VectorLevel level, const Vec3& gravity, double dt, const DomainDeck& domain,
                                     std::span<const Mark> marks, std::span<std::int32_t> moved, Particles& particles);

/// Sets force scales and the conversion to accelerations of all owned particles, from their radii and materials: one
/// unit of the fixed-point sum is a power of two such that the greatest force a contact may have (at an overlap of
/// `max_overlap` of the radius, with the stiffest partner, with room for damping) needs fixed_point_bits - 1 bits.
void set_fixed_point_scales(const MaterialTable& materials, double max_overlap, Particles& particles);

}  // namespace repose
