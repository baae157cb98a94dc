#pragma once

#include "base/quad.h"
#include "contact/fixed_point.h"
#include "contact/geometry.h"
#include "neighbours/contact_block.h"
#include "scene/particles/particles.h"

// What the loops over pair and wall contacts share. They take the lanes of a block four at a time, in passes over the
// whole block that hand their results on in columns. A pass ends where the next operation would wait for a root, a
// division or a gather: the processor, which looks some hundred instructions ahead, then finds those of several quads
// to overlap. Everything is inlined, for the vector level of the caller (base/vector_level.h).

namespace repose {

/// Asks for what the loops read and write of a particle.
[[gnu::always_inline]] inline void fetch_ahead(std::int32_t particle, const ParticleRecord* records,
                                               const ForceSum* sums) {
  const auto* record = reinterpret_cast<const char*>(records + particle);
  __builtin_prefetch(record);
  __builtin_prefetch(record + 64);
  __builtin_prefetch(sums + particle, 1);
}

/// One particle of each of four lanes.
struct QuadParticle {
  QuadVec3 position, velocity, spin;
  Quad radius, force_scale, torque_scale;
};

[[gnu::always_inline]] inline QuadParticle gather(const ParticleRecord* records, const std::int32_t* index) {
  const auto* r0 = reinterpret_cast<const QuadInMemory*>(records + index[0]);
  const auto* r1 = reinterpret_cast<const QuadInMemory*>(records + index[1]);
  const auto* r2 = reinterpret_cast<const QuadInMemory*>(records + index[2]);
  const auto* r3 = reinterpret_cast<const QuadInMemory*>(records + index[3]);
  QuadParticle p = {{r0[0], r1[0], r2[0]}, {r0[1], r1[1], r2[1]}, {r0[2], r1[2], r2[2]}, r3[0], r3[1], r3[2]};
  transpose(p.position.x, p.position.y, p.position.z, p.radius);
  transpose(p.velocity.x, p.velocity.y, p.velocity.z, p.force_scale);
  transpose(p.spin.x, p.spin.y, p.spin.z, p.torque_scale);
  return p;
}

/// A vector of each of four lanes, from and to the columns of its components.
[[gnu::always_inline]] inline QuadVec3 load(const double (&columns)[3][block_lanes], int k) {
  return {load(columns[0] + k), load(columns[1] + k), load(columns[2] + k)};
}
[[gnu::always_inline]] inline void store(const QuadVec3& v, double (&columns)[3][block_lanes], int k) {
  store(v.x, columns[0] + k);
  store(v.y, columns[1] + k);
  store(v.z, columns[2] + k);
}

/// A body's lever arm in each lane, in m, and the scales of its sums.
struct LaneBody {
  alignas(64) double arm[block_lanes], force_scale[block_lanes], torque_scale[block_lanes];
  [[gnu::always_inline]] void set_scales(int k, const QuadParticle& particle) {
    store(particle.force_scale, force_scale + k);
    store(particle.torque_scale, torque_scale + k);
  }
};

/// ContactGeometry by column.
struct LaneGeometry {
  alignas(64) double normal[3][block_lanes], tangential_velocity[3][block_lanes], rolling_velocity[3][block_lanes];
  alignas(64) double overlap[block_lanes], radius_eff[block_lanes], mass_eff[block_lanes], normal_velocity[block_lanes];
  alignas(64) double velocity_normal[3][block_lanes];  // of a law with options
  [[gnu::always_inline]] BasicContactGeometry<Quad> get(int k) const {
    return {.normal = load(normal, k),
            .overlap = load(overlap + k),
            .radius_eff = load(radius_eff + k),
            .mass_eff = load(mass_eff + k),
            .normal_velocity = load(normal_velocity + k),
            .tangential_velocity = load(tangential_velocity, k),
            .rolling_velocity = load(rolling_velocity, k),
            .velocity_normal = load(velocity_normal, k)};
  }
};

[[gnu::always_inline]] inline void add_row(const Quad& row, std::int64_t* sum) {
  *reinterpret_cast<QuadBitsInMemory*>(sum) += reinterpret_cast<QuadBits>(row) - fixed_point_offset_bits;
}

/// Adds offset values to the sums of four particles. `difference` collects what in_fixed_point_range asks for; what is
/// not in range wraps until the alarm is seen.
[[gnu::always_inline]] inline void scatter(Quad x, Quad y, Quad z, std::int64_t* s0, std::int64_t* s1, std::int64_t* s2,
                                           std::int64_t* s3, QuadBits& difference) {
  difference |= (reinterpret_cast<QuadBits>(x) ^ fixed_point_offset_bits) |
                (reinterpret_cast<QuadBits>(y) ^ fixed_point_offset_bits) |
                (reinterpret_cast<QuadBits>(z) ^ fixed_point_offset_bits);
  auto w = broadcast<Quad>(fixed_point_offset);
  transpose(x, y, z, w);
  add_row(x, s0);
  add_row(y, s1);
  add_row(z, s2);
  add_row(w, s3);
}

/// Adds force and torque, already scaled and offset, of four lanes.
[[gnu::always_inline]] inline void scatter(const QuadVec3& force, const QuadVec3& torque, const std::int32_t* index,
                                           ForceSum* sums, QuadBits& difference) {
  ForceSum& s0 = sums[index[0]];
  ForceSum& s1 = sums[index[1]];
  ForceSum& s2 = sums[index[2]];
  ForceSum& s3 = sums[index[3]];
  scatter(force.x, force.y, force.z, s0.force, s1.force, s2.force, s3.force, difference);
  scatter(torque.x, torque.y, torque.z, s0.torque, s1.torque, s2.torque, s3.torque, difference);
}

[[gnu::always_inline]] inline QuadVec3 to_fixed_point(const QuadVec3& v, const Quad& scale) {
  return {to_fixed_point(v.x, scale), to_fixed_point(v.y, scale), to_fixed_point(v.z, scale)};
}
[[gnu::always_inline]] inline QuadVec3 to_fixed_point_negated(const QuadVec3& v, const Quad& scale) {
  return {to_fixed_point_negated(v.x, scale), to_fixed_point_negated(v.y, scale), to_fixed_point_negated(v.z, scale)};
}

/// `v` where `condition` holds, else zero.
[[gnu::always_inline]] inline QuadVec3 where(const QuadInt& condition, const QuadVec3& v) {
  return {select(condition, v.x, Quad{}), select(condition, v.y, Quad{}), select(condition, v.z, Quad{})};
}

}  // namespace repose
