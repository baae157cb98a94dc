#include "contact/pair_loop.h"

#include "base/quad.h"
#include "contact/contact_law.h"
#include "contact/fixed_point.h"
#include "scene/sphere.h"

// The loop runs in three phases per block: gather the records of both particles into columns, evaluate the contact law
// column by column, scatter the forces. The middle phase is plain C++ over the lanes, which the compiler vectorises.

namespace repose {
namespace {

/// One particle of each lane, by column.
struct LaneRecords {
  alignas(64) double x[block_lanes], y[block_lanes], z[block_lanes], radius[block_lanes];
  alignas(64) double vx[block_lanes], vy[block_lanes], vz[block_lanes], force_scale[block_lanes];
  alignas(64) double wx[block_lanes], wy[block_lanes], wz[block_lanes], torque_scale[block_lanes];
};

/// Force and torque on one particle of each lane, by column, offset for the fixed-point sum (fixed_point.h).
struct LaneForces {
  alignas(64) double fx[block_lanes], fy[block_lanes], fz[block_lanes];
  alignas(64) double tx[block_lanes], ty[block_lanes], tz[block_lanes];
};

/// One quad of four records as four columns. Written out: GCC keeps arrays of vectors in memory.
[[gnu::always_inline]] inline void gather_quads(const char* r0, const char* r1, const char* r2, const char* r3,
                                                std::size_t offset, double* c0, double* c1, double* c2, double* c3) {
  Quad a = *reinterpret_cast<const Quad*>(r0 + offset);
  Quad b = *reinterpret_cast<const Quad*>(r1 + offset);
  Quad c = *reinterpret_cast<const Quad*>(r2 + offset);
  Quad d = *reinterpret_cast<const Quad*>(r3 + offset);
  transpose(a, b, c, d);
  *reinterpret_cast<Quad*>(c0) = a;
  *reinterpret_cast<Quad*>(c1) = b;
  *reinterpret_cast<Quad*>(c2) = c;
  *reinterpret_cast<Quad*>(c3) = d;
}

[[gnu::always_inline]] inline const char* address(const ParticleRecord* records, std::int32_t index) {
  const std::size_t triple = 3 * static_cast<std::size_t>(static_cast<std::uint32_t>(index));
  return reinterpret_cast<const char*>(records) + (triple << 5);
}

[[gnu::always_inline]] inline void gather(const ParticleRecord* records, const std::int32_t* index,
                                          LaneRecords& lanes) {
  for (int k = 0; k < block_lanes; k += 4) {
    const char* r0 = address(records, index[k]);
    const char* r1 = address(records, index[k + 1]);
    const char* r2 = address(records, index[k + 2]);
    const char* r3 = address(records, index[k + 3]);
    gather_quads(r0, r1, r2, r3, 0, lanes.x + k, lanes.y + k, lanes.z + k, lanes.radius + k);
    gather_quads(r0, r1, r2, r3, 32, lanes.vx + k, lanes.vy + k, lanes.vz + k, lanes.force_scale + k);
    gather_quads(r0, r1, r2, r3, 64, lanes.wx + k, lanes.wy + k, lanes.wz + k, lanes.torque_scale + k);
  }
}

[[gnu::always_inline]] inline void add_row(const Quad& row, std::int64_t* sum) {
  constexpr auto offset = std::bit_cast<std::uint64_t>(fixed_point_offset);
  *reinterpret_cast<QuadBits*>(sum) += reinterpret_cast<QuadBits>(row) - offset;
}

[[gnu::always_inline]] inline void add_quad(const double* c0, const double* c1, const double* c2, std::int64_t* sum0,
                                            std::int64_t* sum1, std::int64_t* sum2, std::int64_t* sum3) {
  Quad a = *reinterpret_cast<const Quad*>(c0);
  Quad b = *reinterpret_cast<const Quad*>(c1);
  Quad c = *reinterpret_cast<const Quad*>(c2);
  Quad d = {fixed_point_offset, fixed_point_offset, fixed_point_offset, fixed_point_offset};
  transpose(a, b, c, d);
  add_row(a, sum0);
  add_row(b, sum1);
  add_row(c, sum2);
  add_row(d, sum3);
}

[[gnu::always_inline]] inline void scatter(const LaneForces& lanes, const std::int32_t* index, ForceSum* sums) {
  for (int k = 0; k < block_lanes; k += 4) {
    ForceSum& s0 = sums[index[k]];
    ForceSum& s1 = sums[index[k + 1]];
    ForceSum& s2 = sums[index[k + 2]];
    ForceSum& s3 = sums[index[k + 3]];
    add_quad(lanes.fx + k, lanes.fy + k, lanes.fz + k, s0.force, s1.force, s2.force, s3.force);
    add_quad(lanes.tx + k, lanes.ty + k, lanes.tz + k, s0.torque, s1.torque, s2.torque, s3.torque);
  }
}

/// Asks for what a later block will read and write, a part at a time between the phases of the present one: the
/// processor can wait for some twenty lines at once, and stands still when asked for more.
class Prefetch {
 public:
  [[gnu::always_inline]] Prefetch(std::span<const ContactBlock> blocks, const FetchList& fetch, std::size_t later,
                                  const ParticleRecord* records, const ForceSum* sums)
      : records_(records), sums_(sums) {
    if (later >= blocks.size()) return;
    line_ = reinterpret_cast<const char*>(&blocks[later]);
    if (!fetch.end.empty()) particles_ = fetch.of_block(later);
  }
  [[gnu::always_inline]] void part(std::size_t k) const {
    if (line_ == nullptr) return;
    constexpr std::size_t bytes = sizeof(ContactBlock) / parts;
    for (std::size_t at = k * bytes; at < (k + 1) * bytes; at += 64) __builtin_prefetch(line_ + at, 1);
    for (std::size_t p = k * particles_.size() / parts; p < (k + 1) * particles_.size() / parts; ++p) {
      const char* record = address(records_, particles_[p]);
      __builtin_prefetch(record);
      __builtin_prefetch(record + 64);
      __builtin_prefetch(sums_ + particles_[p], 1);
    }
  }

 private:
  static constexpr std::size_t parts = 7;
  const ParticleRecord* records_;
  const ForceSum* sums_;
  const char* line_ = nullptr;
  std::span<const std::int32_t> particles_;
};

/// The bits in which an offset value differs from the offset: none at fixed_point_bits or above if it is in range.
[[gnu::always_inline]] inline std::uint64_t difference(double offset_value) {
  return std::bit_cast<std::uint64_t>(offset_value) ^ std::bit_cast<std::uint64_t>(fixed_point_offset);
}

/// Whether all is in range, of the forces and torques of a block; what is not wraps until the alarm is seen.
[[gnu::always_inline]] inline bool in_range(const LaneForces& a, const LaneForces& b) {
  std::uint64_t any = 0;
  for (int k = 0; k < block_lanes; ++k) {
    any |= difference(a.fx[k]) | difference(a.fy[k]) | difference(a.fz[k]);
    any |= difference(a.tx[k]) | difference(a.ty[k]) | difference(a.tz[k]);
    any |= difference(b.fx[k]) | difference(b.fy[k]) | difference(b.fz[k]);
    any |= difference(b.tx[k]) | difference(b.ty[k]) | difference(b.tz[k]);
  }
  return (any >> fixed_point_bits) == 0;
}

/// Three columns that are the components of a vector of each lane.
struct LaneVectors {
  alignas(64) double x[block_lanes], y[block_lanes], z[block_lanes];
  [[gnu::always_inline]] Vec3 at(int k) const { return {x[k], y[k], z[k]}; }
  [[gnu::always_inline]] void set(int k, const Vec3& v) {
    x[k] = v.x;
    y[k] = v.y;
    z[k] = v.z;
  }
};

/// ContactGeometry by column, and what the torques need beyond it.
struct LaneGeometry {
  LaneVectors normal, tangential_velocity, rolling_velocity;
  alignas(64) double overlap[block_lanes], radius_eff[block_lanes], mass_eff[block_lanes];
  alignas(64) double normal_velocity[block_lanes], arm_a[block_lanes], arm_b[block_lanes];
};

/// Returns the number of contacts deeper than `max_overlap` times the smaller radius.
[[gnu::always_inline]] inline std::int64_t evaluate_geometry(const PairParameters& pair, double max_overlap,
                                                             const LaneRecords& a, const LaneRecords& b,
                                                             LaneGeometry& contact) {
  const double density_first = pair.density_first;
  const double density_second = pair.density_second;
  std::int64_t too_deep = 0;
#pragma GCC ivdep
  for (int k = 0; k < block_lanes; ++k) {
    const Vec3 d = {a.x[k] - b.x[k], a.y[k] - b.y[k], a.z[k] - b.z[k]};
    const double distance = norm(d);
    const double gap = a.radius[k] + b.radius[k] - distance;
    const double overlap = gap > 0.0 ? gap : 0.0;
    const Vec3 n = (1.0 / distance) * d;

    const Vec3 spin_a = {a.wx[k], a.wy[k], a.wz[k]};
    const Vec3 spin_b = {b.wx[k], b.wy[k], b.wz[k]};
    const double arm_a = a.radius[k] - 0.5 * overlap;
    const double arm_b = b.radius[k] - 0.5 * overlap;
    const Vec3 v = {a.vx[k] - b.vx[k], a.vy[k] - b.vy[k], a.vz[k] - b.vz[k]};
    const double v_n = dot(v, n);
    const double mass_a = sphere_mass(a.radius[k], density_first);
    const double mass_b = sphere_mass(b.radius[k], density_second);

    contact.normal.set(k, n);
    contact.overlap[k] = overlap;
    contact.radius_eff[k] = a.radius[k] * b.radius[k] / (a.radius[k] + b.radius[k]);
    contact.mass_eff[k] = mass_a * mass_b / (mass_a + mass_b);
    contact.normal_velocity[k] = v_n;
    contact.tangential_velocity.set(k, v - v_n * n - cross(arm_a * spin_a + arm_b * spin_b, n));
    contact.rolling_velocity.set(k, without_normal_part(spin_a - spin_b, n));
    contact.arm_a[k] = arm_a;
    contact.arm_b[k] = arm_b;
    const double smaller = a.radius[k] < b.radius[k] ? a.radius[k] : b.radius[k];
    too_deep += overlap > max_overlap * smaller ? 1 : 0;
  }
  return too_deep;
}

[[gnu::always_inline]] inline void evaluate_law(const PairParameters& pair_in, double dt, const LaneGeometry& lanes,
                                                const LaneRecords& a, const LaneRecords& b, ContactBlock& block,
                                                LaneForces& on_a, LaneForces& on_b) {
  const PairParameters pair = pair_in;  // a copy: its members cannot be what the loop writes
#pragma GCC ivdep
  for (int k = 0; k < block_lanes; ++k) {
    const ContactGeometry contact = {
        .normal = {lanes.normal.x[k], lanes.normal.y[k], lanes.normal.z[k]},
        .overlap = lanes.overlap[k],
        .radius_eff = lanes.radius_eff[k],
        .mass_eff = lanes.mass_eff[k],
        .normal_velocity = lanes.normal_velocity[k],
        .tangential_velocity = {lanes.tangential_velocity.x[k], lanes.tangential_velocity.y[k],
                                lanes.tangential_velocity.z[k]},
        .rolling_velocity = {lanes.rolling_velocity.x[k], lanes.rolling_velocity.y[k], lanes.rolling_velocity.z[k]}};
    ContactHistory history = {{block.spring[0][k], block.spring[1][k], block.spring[2][k]},
                              {block.rolling[0][k], block.rolling[1][k], block.rolling[2][k]}};
    const ContactForces forces = contact_law(pair, contact, dt, history);

    // Without overlap all stiffness is zero, and so is every force; only the histories have to be cut.
    const bool touching = contact.overlap > 0.0;
    history.spring.x = touching ? history.spring.x : 0.0;
    history.spring.y = touching ? history.spring.y : 0.0;
    history.spring.z = touching ? history.spring.z : 0.0;
    history.rolling.x = touching ? history.rolling.x : 0.0;
    history.rolling.y = touching ? history.rolling.y : 0.0;
    history.rolling.z = touching ? history.rolling.z : 0.0;
    block.spring[0][k] = history.spring.x;
    block.spring[1][k] = history.spring.y;
    block.spring[2][k] = history.spring.z;
    block.rolling[0][k] = history.rolling.x;
    block.rolling[1][k] = history.rolling.y;
    block.rolling[2][k] = history.rolling.z;

    const Vec3 f = forces.force;
    const Vec3 t_a = lanes.arm_a[k] * forces.friction_arm + history.rolling;  // taken from the first body
    const Vec3 t_b = history.rolling - lanes.arm_b[k] * forces.friction_arm;
    on_a.fx[k] = to_fixed_point(f.x, a.force_scale[k]);
    on_a.fy[k] = to_fixed_point(f.y, a.force_scale[k]);
    on_a.fz[k] = to_fixed_point(f.z, a.force_scale[k]);
    on_a.tx[k] = to_fixed_point_negated(t_a.x, a.torque_scale[k]);
    on_a.ty[k] = to_fixed_point_negated(t_a.y, a.torque_scale[k]);
    on_a.tz[k] = to_fixed_point_negated(t_a.z, a.torque_scale[k]);
    on_b.fx[k] = to_fixed_point_negated(f.x, b.force_scale[k]);
    on_b.fy[k] = to_fixed_point_negated(f.y, b.force_scale[k]);
    on_b.fz[k] = to_fixed_point_negated(f.z, b.force_scale[k]);
    on_b.tx[k] = to_fixed_point(t_b.x, b.torque_scale[k]);
    on_b.ty[k] = to_fixed_point(t_b.y, b.torque_scale[k]);
    on_b.tz[k] = to_fixed_point(t_b.z, b.torque_scale[k]);
  }
}

[[gnu::always_inline]] inline PairLoopAlarms evaluate_body(std::span<ContactBlock> blocks, const FetchList& fetch,
                                                           const PairParameters& pair, double dt, double max_overlap,
                                                           const ParticleRecord* records, ForceSum* sums) {
  LaneRecords a, b;
  LaneGeometry contact;
  LaneForces on_a, on_b;
  PairLoopAlarms alarms;
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    const Prefetch prefetch(blocks, fetch, k + 2, records, sums);
    ContactBlock& block = blocks[k];
    prefetch.part(0);
    gather(records, block.first, a);
    prefetch.part(1);
    gather(records, block.second, b);
    prefetch.part(2);
    alarms.too_deep += evaluate_geometry(pair, max_overlap, a, b, contact);
    prefetch.part(3);
    evaluate_law(pair, dt, contact, a, b, block, on_a, on_b);
    prefetch.part(4);
    alarms.out_of_range += in_range(on_a, on_b) ? 0 : 1;
    prefetch.part(5);
    scatter(on_a, block.first, sums);
    prefetch.part(6);
    scatter(on_b, block.second, sums);
  }
  return alarms;
}

}  // namespace

PairLoopAlarms evaluate_pairs(VectorLevel level, std::span<ContactBlock> blocks, const FetchList& fetch,
                              const PairParameters& pair, double dt, double max_overlap, const ParticleRecord* records,
                              ForceSum* sums) {
  return at_level(level,
                  [&]() REPOSE_INLINE { return evaluate_body(blocks, fetch, pair, dt, max_overlap, records, sums); });
}

}  // namespace repose
