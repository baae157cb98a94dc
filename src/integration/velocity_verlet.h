#pragma once

#include "scene/particles.h"

namespace repose {

class MaterialTable;

/// Velocity Verlet with forces from half-step velocities: v += a dt/2, x += v dt, [forces], v += a dt/2; the same for
/// the spins. `gravity` in m/s2, `dt` in s. Owned particles only.
void kick_half_step(const Vec3& gravity, double dt, Particles& particles);
void drift(double dt, Particles& particles);

/// Sets force scales and the conversion to accelerations of all owned particles, from their radii and materials: one
/// unit of the fixed-point sum is a power of two such that the greatest force a contact may have (at an overlap of
/// `max_overlap` of the radius, with the stiffest partner, with room for damping) needs fixed_point_bits - 1 bits.
void set_fixed_point_scales(const MaterialTable& materials, double max_overlap, Particles& particles);

}  // namespace repose
