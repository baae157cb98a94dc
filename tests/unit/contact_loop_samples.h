#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "contact/pair_loop.h"
#include "integration/velocity_verlet.h"
#include "neighbours/pair_lists.h"
#include "scene/particles/sphere_mass.h"
#include "support/contact_law.h"
#include "support/draw.h"
#include "support/fixed_point_sum.h"

namespace repose::test {

inline constexpr double loop_dt = 1e-6;
inline constexpr double loop_max_overlap = 0.3;

struct Loop {
  Particles particles;
  std::vector<ContactBlock> blocks;
  std::size_t pairs = 0;
};

struct Outcome {
  std::vector<ContactBlock> blocks;
  std::vector<ForceSum> sums;
  ContactAlarms alarms;
};

/// Signed overlaps, over the smaller radius: deep, usual, a last-digit touch, exact touch, gaps.
inline double random_overlap(Draw& draw) {
  switch (draw.below(6)) {
    case 0:
      return draw(0.05, 0.29);
    case 1:
      return draw(1e-9, 1e-3);
    case 2:
      return draw(-4e-16, 4e-16);
    case 3:
      return 0.0;
    case 4:
      return draw(-1e-3, -1e-9);
    default:
      return draw(-30.0, -0.1);
  }
}

inline ParticleRecord random_grain(Draw& draw, const Vec3& position, double radius) {
  ParticleRecord record = {};
  record.position = position;
  record.radius = radius;
  record.velocity = draw.vector(0.2);
  record.spin = draw.vector(200.0);
  return record;
}

/// `pairs` pairs of grains with radii from 0.1 to 1 mm; every third pair shares its first grain with the pair before.
inline Loop random_loop(std::uint64_t seed, std::size_t pairs, const MaterialTable& materials) {
  Draw draw(seed);
  Loop loop;
  loop.pairs = pairs;
  Particles& p = loop.particles;
  std::vector<std::array<std::size_t, 2>> indices;
  for (std::size_t k = 0; k < pairs; ++k) {
    if (k % 3 != 1) p.record.push_back(random_grain(draw, draw.vector(0.05), draw(1e-4, 1e-3)));
    const std::size_t first = k % 3 != 1 ? p.record.size() - 1 : indices.back()[0];
    const ParticleRecord a = p.record[first];
    const double radius = draw(1e-4, 1e-3);
    const double apart = a.radius + radius - random_overlap(draw) * std::min(a.radius, radius);
    p.record.push_back(random_grain(draw, a.position + apart * draw.direction(), radius));
    indices.push_back({first, p.record.size() - 1});
  }
  p.owned = p.record.size();
  for (std::size_t i = 0; i < p.owned; ++i) p.id.push_back(static_cast<std::int64_t>(i));
  p.material.assign(p.owned, 0);
  set_fixed_point_scales(materials, loop_max_overlap, p);
  add_lane_dummies(p);

  const auto dummy = static_cast<std::int32_t>(p.total());
  loop.blocks.resize(blocks_for(pairs));
  for (std::size_t k = 0; k < block_lanes * loop.blocks.size(); ++k) {
    ContactBlock& block = loop.blocks[k / block_lanes];
    const std::size_t lane = k % block_lanes;
    const bool used = k < pairs;
    block.first[lane] = used ? static_cast<std::int32_t>(indices[k][0]) : dummy;
    block.second[lane] = used ? static_cast<std::int32_t>(indices[k][1]) : dummy + 1;
    const bool remembers = used && draw(0.0, 1.0) < 0.7;
    for (auto& column : block.spring) column[lane] = remembers ? draw(-1e-6, 1e-6) : 0.0;
    for (auto& column : block.rolling) column[lane] = remembers ? draw(-1e-9, 1e-9) : 0.0;
  }
  return loop;
}

inline Outcome evaluate(VectorLevel level, const Loop& loop, const PairParameters& pair, double step = loop_dt) {
  Outcome outcome = {loop.blocks, std::vector<ForceSum>(loop.particles.record.size(), ForceSum{}), {}};
  outcome.alarms = evaluate_pairs(level, outcome.blocks, pair, step, loop_max_overlap, loop.particles.record.data(),
                                  outcome.sums.data());
  return outcome;
}

inline bool add(const Vec3& v, double scale, std::int64_t* sum) {
  bool fits = add_fixed_point(to_fixed_point(v.x, scale), sum[0]);
  fits &= add_fixed_point(to_fixed_point(v.y, scale), sum[1]);
  return add_fixed_point(to_fixed_point(v.z, scale), sum[2]) && fits;
}

/// One lane, written as the theory says it.
inline void evaluate_scalar(const ParticleRecord& a, const ParticleRecord& b, const PairParameters& pair,
                            ContactHistory& history, ForceSum& on_a, ForceSum& on_b, ContactAlarms& alarms) {
  const Vec3 apart = a.position - b.position;
  const double distance = norm(apart);
  ContactGeometry contact = {};
  contact.radius_eff = a.radius * b.radius / (a.radius + b.radius);
  contact.overlap = with_law(pair, [&](auto law) {
    return decltype(law)::overlap(pair, a.radius + b.radius - distance, contact.radius_eff, !is_blank(history));
  });
  if (contact.overlap == 0.0) {
    history = {};
    return;
  }
  contact.normal = (1.0 / distance) * apart;
  const double mass_a = sphere_mass(a.radius, pair.density_first);
  const double mass_b = sphere_mass(b.radius, pair.density_second);
  contact.mass_eff = mass_a * mass_b / (mass_a + mass_b);
  const double arm_a = a.radius - 0.5 * contact.overlap;
  const double arm_b = b.radius - 0.5 * contact.overlap;
  contact.rolling_inertia = rolling_inertia(mass_a * (a.radius * a.radius), mass_b * (b.radius * b.radius));
  contact.cohesive_area = cohesive_area_of_spheres(pair, a.radius, b.radius, distance, contact.overlap);
  const Vec3 velocity = a.velocity - b.velocity;
  const Vec3 n_v = with_law(
      pair, [&](auto law) { return decltype(law)::velocity_normal(pair, loop_dt, apart, velocity, contact.normal); });
  contact.velocity_normal = n_v;
  contact.normal_velocity = dot(velocity, n_v);
  contact.tangential_velocity = velocity - contact.normal_velocity * n_v - cross(arm_a * a.spin + arm_b * b.spin, n_v);
  contact.rolling_velocity = without_normal_part(a.spin - b.spin, n_v);
  contact.twist = dot(a.spin - b.spin, n_v);
  const ContactForces forces = contact_law(pair, contact, loop_dt, history);
  alarms.too_deep += contact.overlap > loop_max_overlap * std::min(a.radius, b.radius) ? 1 : 0;
  bool fits = add(forces.force, a.force_scale, on_a.force);
  fits &= add(-forces.force, b.force_scale, on_b.force);
  fits &= add(-(arm_a * forces.friction_arm) - forces.rolling_moment, a.torque_scale, on_a.torque);
  fits &= add(forces.rolling_moment - arm_b * forces.friction_arm, b.torque_scale, on_b.torque);
  alarms.out_of_range += fits ? 0 : 1;
}

inline Outcome evaluate_scalar(const Loop& loop, const PairParameters& pair) {
  Outcome outcome = {loop.blocks, std::vector<ForceSum>(loop.particles.record.size(), ForceSum{}), {}};
  for (std::size_t k = 0; k < loop.pairs; ++k) {
    ContactBlock& block = outcome.blocks[k / block_lanes];
    const std::size_t lane = k % block_lanes;
    const auto first = static_cast<std::size_t>(block.first[lane]);
    const auto second = static_cast<std::size_t>(block.second[lane]);
    ContactHistory h = history(block, lane);
    evaluate_scalar(loop.particles.record[first], loop.particles.record[second], pair, h, outcome.sums[first],
                    outcome.sums[second], outcome.alarms);
    set_history(block, lane, h);
  }
  return outcome;
}

}  // namespace repose::test
