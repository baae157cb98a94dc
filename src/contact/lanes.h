#pragma once

#include "base/quad.h"
#include "contact/fixed_point.h"
#include "contact/geometry.h"
#include "neighbours/contact_block.h"
#include "scene/particles/particles.h"

// What the loops over pair and wall contacts share. They take the lanes of a block four or eight at a time, in passes
// over the whole block that hand their results on in columns. A pass ends where the next operation would wait for a
// root, a division or a gather: the processor, which looks some hundred instructions ahead, then finds those of several
// of them to overlap. Everything is inlined, for the vector level of the caller (base/vector_level.h).

namespace repose {

/// One particle of each lane.
template <Lanes Real>
struct LaneParticle {
  Vector3<Real> position, velocity, spin;
  Real radius, force_scale, torque_scale;
};

template <Lanes Real>
[[gnu::always_inline]] inline LaneParticle<Real> gather(const ParticleRecord* records, const std::int32_t* index) {
  const QuadInMemory* row[lanes_of<Real>];
  for (int k = 0; k < lanes_of<Real>; ++k) row[k] = reinterpret_cast<const QuadInMemory*>(records + index[k]);
  LaneParticle<Real> p;
  load_rows(row, 0, p.position.x, p.position.y, p.position.z, p.radius);
  load_rows(row, 1, p.velocity.x, p.velocity.y, p.velocity.z, p.force_scale);
  load_rows(row, 2, p.spin.x, p.spin.y, p.spin.z, p.torque_scale);
  return p;
}

/// A vector of each lane, from and to the columns of its components.
template <Lanes Real>
[[gnu::always_inline]] inline Vector3<Real> load(const double (&columns)[3][block_lanes], int k) {
  return {load<Real>(columns[0] + k), load<Real>(columns[1] + k), load<Real>(columns[2] + k)};
}
template <Lanes Real>
[[gnu::always_inline]] inline void store(const Vector3<Real>& v, double (&columns)[3][block_lanes], int k) {
  store(v.x, columns[0] + k);
  store(v.y, columns[1] + k);
  store(v.z, columns[2] + k);
}

/// Whether a lane's contact has touched (GeneralLaw::remembered).
template <Lanes Real>
[[gnu::always_inline]] inline LaneInt<Real> remembers(const ContactBlock& block, int k) {
  return reinterpret_cast<LaneBits<Real>>(load<Real>(block.spring[0] + k)) != 0;
}

/// A body's lever arm in each lane, in m, and the scales of its sums.
struct LaneBody {
  alignas(64) double arm[block_lanes], force_scale[block_lanes], torque_scale[block_lanes];
  template <Lanes Real>
  [[gnu::always_inline]] void set_scales(int k, const LaneParticle<Real>& particle) {
    store(particle.force_scale, force_scale + k);
    store(particle.torque_scale, torque_scale + k);
  }
};

/// ContactGeometry by column.
struct LaneGeometry {
  alignas(64) double normal[3][block_lanes], tangential_velocity[3][block_lanes], rolling_velocity[3][block_lanes];
  alignas(64) double overlap[block_lanes], radius_eff[block_lanes], mass_eff[block_lanes], normal_velocity[block_lanes];
  // Of a law with options alone.
  alignas(64) double velocity_normal[3][block_lanes], twist[block_lanes], rolling_inertia[block_lanes],
      cohesive_area[block_lanes];
  template <Lanes Real>
  [[gnu::always_inline]] BasicContactGeometry<Real> get(int k) const {
    return {.normal = load<Real>(normal, k),
            .overlap = load<Real>(overlap + k),
            .radius_eff = load<Real>(radius_eff + k),
            .mass_eff = load<Real>(mass_eff + k),
            .normal_velocity = load<Real>(normal_velocity + k),
            .tangential_velocity = load<Real>(tangential_velocity, k),
            .rolling_velocity = load<Real>(rolling_velocity, k),
            .velocity_normal = load<Real>(velocity_normal, k),
            .twist = load<Real>(twist + k),
            .rolling_inertia = load<Real>(rolling_inertia + k),
            .cohesive_area = load<Real>(cohesive_area + k)};
  }
};

/// Adds offset values, of one particle or two, to its sum or theirs.
template <Lanes Real>
[[gnu::always_inline]] inline void add_offset(const Real& row, std::int64_t* sum) {
  *reinterpret_cast<typename LaneTypes<Real>::BitsInMemory*>(sum) +=
      reinterpret_cast<LaneBits<Real>>(row) - fixed_point_offset_bits;
}

/// Adds rows of force and torque, by column, to the sums of the lanes' particles.
[[gnu::always_inline]] inline void add_columns(const QuadVec3& force, const QuadVec3& torque,
                                               ForceSum* const (&sum)[4]) {
  const auto padding = broadcast<Quad>(fixed_point_offset);
  Quad f[] = {force.x, force.y, force.z, padding};
  transpose(f[0], f[1], f[2], f[3]);
  for (int k = 0; k < 4; ++k) add_offset(f[k], sum[k]->force);
  Quad t[] = {torque.x, torque.y, torque.z, padding};
  transpose(t[0], t[1], t[2], t[3]);
  for (int k = 0; k < 4; ++k) add_offset(t[k], sum[k]->torque);
}
[[gnu::always_inline]] inline void add_columns(const Vector3<Octet>& force, const Vector3<Octet>& torque,
                                               ForceSum* const (&sum)[8]) {
  const auto padding = broadcast<Octet>(fixed_point_offset);
  Octet row[] = {force.x, force.y, force.z, padding, torque.x, torque.y, torque.z, padding};
  transpose(row);
  for (int k = 0; k < 8; ++k) add_offset(row[k], sum[k]->force);
}

/// Adds force and torque, already scaled and offset, of all lanes. `difference` collects what in_fixed_point_range asks
/// for; what is not in range wraps until the alarm is seen.
template <Lanes Real>
[[gnu::always_inline]] inline void scatter(const Vector3<Real>& force, const Vector3<Real>& torque,
                                           const std::int32_t* index, ForceSum* sums, LaneBits<Real>& difference) {
  for (const Real& x : {force.x, force.y, force.z, torque.x, torque.y, torque.z}) {
    difference |= reinterpret_cast<LaneBits<Real>>(x) ^ fixed_point_offset_bits;
  }
  ForceSum* sum[lanes_of<Real>];
  for (int k = 0; k < lanes_of<Real>; ++k) sum[k] = sums + index[k];
  add_columns(force, torque, sum);
}

template <Lanes Real>
[[gnu::always_inline]] inline Vector3<Real> to_fixed_point(const Vector3<Real>& v, const Real& scale) {
  return {to_fixed_point(v.x, scale), to_fixed_point(v.y, scale), to_fixed_point(v.z, scale)};
}
template <Lanes Real>
[[gnu::always_inline]] inline Vector3<Real> to_fixed_point_negated(const Vector3<Real>& v, const Real& scale) {
  return {to_fixed_point_negated(v.x, scale), to_fixed_point_negated(v.y, scale), to_fixed_point_negated(v.z, scale)};
}

/// `v` where `condition` holds, else zero.
template <Lanes Real>
[[gnu::always_inline]] inline Vector3<Real> where(const LaneInt<Real>& condition, const Vector3<Real>& v) {
  return {select(condition, v.x, Real{}), select(condition, v.y, Real{}), select(condition, v.z, Real{})};
}

}  // namespace repose
