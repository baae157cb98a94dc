#include "contact/pair_loop.h"

#include "base/error.h"
#include "contact/contact_law.h"
#include "contact/fixed_point.h"
#include "contact/quad.h"
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

[[gnu::always_inline]] inline void gather_quads(const ParticleRecord* records, const std::int32_t* index, int quad,
                                                double* c0, double* c1, double* c2, double* c3) {
  Quad rows[4];
  for (int lane = 0; lane < 4; ++lane) {
    std::memcpy(&rows[lane], reinterpret_cast<const char*>(&records[index[lane]]) + 32 * quad, sizeof(Quad));
  }
  transpose(rows[0], rows[1], rows[2], rows[3]);
  std::memcpy(c0, &rows[0], sizeof(Quad));
  std::memcpy(c1, &rows[1], sizeof(Quad));
  std::memcpy(c2, &rows[2], sizeof(Quad));
  std::memcpy(c3, &rows[3], sizeof(Quad));
}

[[gnu::always_inline]] inline void gather(const ParticleRecord* records, const std::int32_t* index,
                                          LaneRecords& lanes) {
  for (int k = 0; k < block_lanes; k += 4) {
    gather_quads(records, index + k, 0, lanes.x + k, lanes.y + k, lanes.z + k, lanes.radius + k);
    gather_quads(records, index + k, 1, lanes.vx + k, lanes.vy + k, lanes.vz + k, lanes.force_scale + k);
    gather_quads(records, index + k, 2, lanes.wx + k, lanes.wy + k, lanes.wz + k, lanes.torque_scale + k);
  }
}

[[gnu::always_inline]] inline void add_quad(const double* c0, const double* c1, const double* c2,
                                            std::int64_t* const* sums, QuadBits& out_of_range) {
  Quad rows[4];
  std::memcpy(&rows[0], c0, sizeof(Quad));
  std::memcpy(&rows[1], c1, sizeof(Quad));
  std::memcpy(&rows[2], c2, sizeof(Quad));
  rows[3] = Quad{fixed_point_offset, fixed_point_offset, fixed_point_offset, fixed_point_offset};
  transpose(rows[0], rows[1], rows[2], rows[3]);
  constexpr auto offset_bits = std::bit_cast<std::uint64_t>(fixed_point_offset);
  const QuadBits offset = {offset_bits, offset_bits, offset_bits, offset_bits};
  for (int lane = 0; lane < 4; ++lane) {
    QuadBits bits;
    QuadBits sum;  // unsigned: what is out of range wraps until the alarm is seen
    std::memcpy(&bits, &rows[lane], sizeof(QuadBits));
    std::memcpy(&sum, sums[lane], sizeof(QuadBits));
    out_of_range |= bits ^ offset;
    sum += bits - offset;
    std::memcpy(sums[lane], &sum, sizeof(QuadBits));
  }
}

[[gnu::always_inline]] inline void scatter(const LaneForces& lanes, const std::int32_t* index, ForceSum* sums,
                                           QuadBits& out_of_range) {
  for (int k = 0; k < block_lanes; k += 4) {
    std::int64_t* force[4];
    std::int64_t* torque[4];
    for (int lane = 0; lane < 4; ++lane) {
      force[lane] = sums[index[k + lane]].force;
      torque[lane] = sums[index[k + lane]].torque;
    }
    add_quad(lanes.fx + k, lanes.fy + k, lanes.fz + k, force, out_of_range);
    add_quad(lanes.tx + k, lanes.ty + k, lanes.tz + k, torque, out_of_range);
  }
}

[[gnu::always_inline]] inline void copy_members(const Vec3& from, Vec3& to) {
  to.x = from.x;
  to.y = from.y;
  to.z = from.z;
}

[[gnu::always_inline]] inline ContactGeometry pair_geometry(const PairParameters& pair, const LaneRecords& a,
                                                            const LaneRecords& b, int k, Vec3& spin_a, Vec3& spin_b,
                                                            double& arm_a, double& arm_b) {
  const Vec3 d = {a.x[k] - b.x[k], a.y[k] - b.y[k], a.z[k] - b.z[k]};
  const double distance = norm(d);
  const double gap = a.radius[k] + b.radius[k] - distance;
  const double overlap = gap > 0.0 ? gap : 0.0;
  const Vec3 n = (1.0 / distance) * d;

  spin_a = {a.wx[k], a.wy[k], a.wz[k]};
  spin_b = {b.wx[k], b.wy[k], b.wz[k]};
  arm_a = a.radius[k] - 0.5 * overlap;
  arm_b = b.radius[k] - 0.5 * overlap;
  const Vec3 v = {a.vx[k] - b.vx[k], a.vy[k] - b.vy[k], a.vz[k] - b.vz[k]};
  const double v_n = dot(v, n);
  const Vec3 surface = v - v_n * n - cross(arm_a * spin_a + arm_b * spin_b, n);

  const double mass_a = sphere_mass(a.radius[k], pair.density_first);
  const double mass_b = sphere_mass(b.radius[k], pair.density_second);
  const double radius_eff = a.radius[k] * b.radius[k] / (a.radius[k] + b.radius[k]);
  const double mass_eff = mass_a * mass_b / (mass_a + mass_b);
  const Vec3 rolling = without_normal_part(spin_a - spin_b, n);
  // Member by member: a Vec3 copied as a whole is one memory block to GCC, which keeps the loop from being vectorised.
  ContactGeometry contact;
  copy_members(n, contact.normal);
  contact.overlap = overlap;
  contact.radius_eff = radius_eff;
  contact.mass_eff = mass_eff;
  contact.normal_velocity = v_n;
  copy_members(surface, contact.tangential_velocity);
  copy_members(rolling, contact.rolling_velocity);
  return contact;
}

[[gnu::always_inline]] inline std::int64_t evaluate_lanes(ContactBlock& block, const PairParameters& pair_in, double dt,
                                                          double max_overlap, const LaneRecords& a,
                                                          const LaneRecords& b, LaneForces& on_a, LaneForces& on_b) {
  const PairParameters pair = pair_in;
  std::int64_t too_deep = 0;
#pragma GCC ivdep
  for (int k = 0; k < block_lanes; ++k) {
    Vec3 spin_a, spin_b;
    double arm_a, arm_b;
    const ContactGeometry contact = pair_geometry(pair, a, b, k, spin_a, spin_b, arm_a, arm_b);
    ContactHistory history = {{block.spring[0][k], block.spring[1][k], block.spring[2][k]},
                              {block.rolling[0][k], block.rolling[1][k], block.rolling[2][k]}};
    const ContactForces forces = contact_law(pair, contact, dt, history);

    const bool touching = contact.overlap > 0.0;
    const double smaller = a.radius[k] < b.radius[k] ? a.radius[k] : b.radius[k];
    too_deep += contact.overlap > max_overlap * smaller ? 1 : 0;
    block.spring[0][k] = touching ? history.spring.x : 0.0;
    block.spring[1][k] = touching ? history.spring.y : 0.0;
    block.spring[2][k] = touching ? history.spring.z : 0.0;
    block.rolling[0][k] = touching ? history.rolling.x : 0.0;
    block.rolling[1][k] = touching ? history.rolling.y : 0.0;
    block.rolling[2][k] = touching ? history.rolling.z : 0.0;

    const Vec3 f = {touching ? forces.force.x : 0.0, touching ? forces.force.y : 0.0, touching ? forces.force.z : 0.0};
    const Vec3 arm = {touching ? forces.friction_arm.x : 0.0, touching ? forces.friction_arm.y : 0.0,
                      touching ? forces.friction_arm.z : 0.0};
    const Vec3 m = {touching ? forces.rolling_moment.x : 0.0, touching ? forces.rolling_moment.y : 0.0,
                    touching ? forces.rolling_moment.z : 0.0};
    const Vec3 t_a = -(arm_a * arm) - m;
    const Vec3 t_b = m - arm_b * arm;
    on_a.fx[k] = to_fixed_point(f.x, a.force_scale[k]);
    on_a.fy[k] = to_fixed_point(f.y, a.force_scale[k]);
    on_a.fz[k] = to_fixed_point(f.z, a.force_scale[k]);
    on_a.tx[k] = to_fixed_point(t_a.x, a.torque_scale[k]);
    on_a.ty[k] = to_fixed_point(t_a.y, a.torque_scale[k]);
    on_a.tz[k] = to_fixed_point(t_a.z, a.torque_scale[k]);
    on_b.fx[k] = to_fixed_point(-f.x, b.force_scale[k]);
    on_b.fy[k] = to_fixed_point(-f.y, b.force_scale[k]);
    on_b.fz[k] = to_fixed_point(-f.z, b.force_scale[k]);
    on_b.tx[k] = to_fixed_point(t_b.x, b.torque_scale[k]);
    on_b.ty[k] = to_fixed_point(t_b.y, b.torque_scale[k]);
    on_b.tz[k] = to_fixed_point(t_b.z, b.torque_scale[k]);
  }
  return too_deep;
}

[[gnu::always_inline]] inline PairLoopAlarms evaluate_body(std::span<ContactBlock> blocks, const PairParameters& pair,
                                                           double dt, double max_overlap, const ParticleRecord* records,
                                                           ForceSum* sums) {
  LaneRecords a, b;
  LaneForces on_a, on_b;
  PairLoopAlarms alarms;
  for (ContactBlock& block : blocks) {
    gather(records, block.first, a);
    gather(records, block.second, b);
    alarms.too_deep += evaluate_lanes(block, pair, dt, max_overlap, a, b, on_a, on_b);
    QuadBits out_of_range = {0, 0, 0, 0};
    scatter(on_a, block.first, sums, out_of_range);
    scatter(on_b, block.second, sums, out_of_range);
    const std::uint64_t any = out_of_range[0] | out_of_range[1] | out_of_range[2] | out_of_range[3];
    alarms.out_of_range += (any >> fixed_point_bits) != 0 ? 1 : 0;
  }
  return alarms;
}

PairLoopAlarms evaluate_sse2(std::span<ContactBlock> blocks, const PairParameters& pair, double dt, double max_overlap,
                             const ParticleRecord* records, ForceSum* sums) {
  return evaluate_body(blocks, pair, dt, max_overlap, records, sums);
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] PairLoopAlarms evaluate_avx2(std::span<ContactBlock> blocks, const PairParameters& pair,
                                                     double dt, double max_overlap, const ParticleRecord* records,
                                                     ForceSum* sums) {
  return evaluate_body(blocks, pair, dt, max_overlap, records, sums);
}

[[gnu::target("avx512f,avx512dq,avx512vl,avx512bw,avx512cd")]] PairLoopAlarms evaluate_avx512(
    std::span<ContactBlock> blocks, const PairParameters& pair, double dt, double max_overlap,
    const ParticleRecord* records, ForceSum* sums) {
  return evaluate_body(blocks, pair, dt, max_overlap, records, sums);
}

bool has(VectorLevel level) {
  if (level == VectorLevel::avx512) return __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
  if (level == VectorLevel::avx2) return __builtin_cpu_supports("avx2");
  return true;
}
#else
// Elsewhere the compiler's own baseline vectors serve: there is one level, under the lowest name.
constexpr auto evaluate_avx2 = evaluate_sse2;
constexpr auto evaluate_avx512 = evaluate_sse2;
bool has(VectorLevel level) { return level == VectorLevel::sse2; }
#endif

}  // namespace

VectorLevel best_vector_level() {
  if (has(VectorLevel::avx512)) return VectorLevel::avx512;
  return has(VectorLevel::avx2) ? VectorLevel::avx2 : VectorLevel::sse2;
}

VectorLevel vector_level_from(const std::string& name) {
  if (name.empty() || name == "auto") return best_vector_level();
  for (const VectorLevel level : {VectorLevel::sse2, VectorLevel::avx2, VectorLevel::avx512}) {
    if (name != to_string(level)) continue;
    if (has(level)) return level;
    throw DeckError("--vector-level " + name + ": this processor lacks it; the best it has is " +
                    to_string(best_vector_level()));
  }
  throw DeckError("--vector-level " + name + ": not a vector level; one of auto, sse2, avx2, avx512");
}

std::string to_string(VectorLevel level) {
  if (level == VectorLevel::avx512) return "avx512";
  return level == VectorLevel::avx2 ? "avx2" : "sse2";
}

PairLoopAlarms evaluate_pairs(VectorLevel level, std::span<ContactBlock> blocks, const PairParameters& pair, double dt,
                              double max_overlap, const ParticleRecord* records, ForceSum* sums) {
  if (level == VectorLevel::avx512) return evaluate_avx512(blocks, pair, dt, max_overlap, records, sums);
  if (level == VectorLevel::avx2) return evaluate_avx2(blocks, pair, dt, max_overlap, records, sums);
  return evaluate_sse2(blocks, pair, dt, max_overlap, records, sums);
}

}  // namespace repose
