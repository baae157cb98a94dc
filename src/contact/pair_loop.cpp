#include "contact/pair_loop.h"

#include "contact/contact_law.h"
#include "scene/particles/sphere_mass.h"

namespace repose {
namespace {

/// The two particles of each pair, by column.
struct LanePairs {
  alignas(64) double apart[3][block_lanes], velocity[3][block_lanes];  // of the first relative to the second
  alignas(64) double first_spin[3][block_lanes], second_spin[3][block_lanes];
  alignas(64) double first_radius[block_lanes], second_radius[block_lanes];
  alignas(64) double distance[block_lanes], one_over_distance[block_lanes];
};

template <Lanes Real>
[[gnu::always_inline]] inline void gather_pairs(const ParticleRecord* records, const ContactBlock& block,
                                                LanePairs& pairs, LaneBody& first, LaneBody& second) {
  for (int k = 0; k < block_lanes; k += lanes_of<Real>) {
    const LaneParticle<Real> a = gather<Real>(records, block.first + k);
    const LaneParticle<Real> b = gather<Real>(records, block.second + k);
    const Vector3<Real> apart = a.position - b.position;
    store(apart, pairs.apart, k);
    store(a.velocity - b.velocity, pairs.velocity, k);
    store(a.spin, pairs.first_spin, k);
    store(b.spin, pairs.second_spin, k);
    store(a.radius, pairs.first_radius + k);
    store(b.radius, pairs.second_radius + k);
    first.set_scales(k, a);
    second.set_scales(k, b);
    store(square_root(squared_norm(apart)), pairs.distance + k);
  }
}

/// Overlaps, effective radii and masses, lever arms. Returns the number of contacts deeper than `max_overlap` times the
/// smaller radius.
template <class Law, Lanes Real>
[[gnu::always_inline]] inline std::int64_t evaluate_overlaps(const PairParameters& pair_in, double max_overlap,
                                                             const ContactBlock& block, LanePairs& pairs,
                                                             LaneGeometry& contact, LaneBody& first, LaneBody& second) {
  const typename Law::Parameters pair = pair_in;
  const double density_first = pair.density_first;
  const double density_second = pair.density_second;
  LaneInt<Real> deep = {};
  for (int k = 0; k < block_lanes; k += lanes_of<Real>) {
    const Real a = load<Real>(pairs.first_radius + k);
    const Real b = load<Real>(pairs.second_radius + k);
    const Real distance = load<Real>(pairs.distance + k);
    const Real radius_eff = a * b / (a + b);
    const Real overlap = Law::overlap(pair, a + b - distance, radius_eff, remembers<Real>(block, k));
    const Real mass_a = sphere_mass(a, density_first);
    const Real mass_b = sphere_mass(b, density_second);
    store(1.0 / distance, pairs.one_over_distance + k);
    store(overlap, contact.overlap + k);
    store(radius_eff, contact.radius_eff + k);
    store(mass_a * mass_b / (mass_a + mass_b), contact.mass_eff + k);
    store(a - 0.5 * overlap, first.arm + k);
    store(b - 0.5 * overlap, second.arm + k);
    const Real smaller = a < b ? a : b;
    deep += overlap > max_overlap * smaller;
    if constexpr (Law::has_options) {
      store(rolling_inertia(mass_a * (a * a), mass_b * (b * b)), contact.rolling_inertia + k);
      store(cohesive_area_of_spheres(pair, a, b, distance, overlap), contact.cohesive_area + k);
    }
  }
  return count(deep);
}

template <class Law, Lanes Real>
[[gnu::always_inline]] inline void evaluate_velocities(const PairParameters& pair_in, double dt, const LanePairs& pairs,
                                                       const LaneBody& first, const LaneBody& second,
                                                       LaneGeometry& contact) {
  const typename Law::Parameters pair = pair_in;
  for (int k = 0; k < block_lanes; k += lanes_of<Real>) {
    const Vector3<Real> n = load<Real>(pairs.one_over_distance + k) * load<Real>(pairs.apart, k);
    const Vector3<Real> v = load<Real>(pairs.velocity, k);
    const Vector3<Real> spin_a = load<Real>(pairs.first_spin, k);
    const Vector3<Real> spin_b = load<Real>(pairs.second_spin, k);
    const Vector3<Real> n_v = Law::velocity_normal(pair, dt, load<Real>(pairs.apart, k), v, n);
    const Real v_n = dot(v, n_v);
    const Vector3<Real> turning = load<Real>(first.arm + k) * spin_a + load<Real>(second.arm + k) * spin_b;
    store(n, contact.normal, k);
    store(v_n, contact.normal_velocity + k);
    store(v - v_n * n_v - cross(turning, n_v), contact.tangential_velocity, k);
    store(without_normal_part(spin_a - spin_b, n_v), contact.rolling_velocity, k);
    if constexpr (Law::has_options) {
      store(n_v, contact.velocity_normal, k);
      store(dot(spin_a - spin_b, n_v), contact.twist + k);
    }
  }
}

template <class Law, Lanes Real>
[[gnu::always_inline]] inline ContactAlarms evaluate_body(std::span<ContactBlock> blocks, const PairParameters& pair,
                                                          double dt, double max_overlap, const ParticleRecord* records,
                                                          ForceSum* sums) {
  LanePairs pairs;
  LaneGeometry contact;
  LaneBody first, second;
  ContactAlarms alarms;
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    gather_pairs<Real>(records, blocks[k], pairs, first, second);
    alarms.too_deep += evaluate_overlaps<Law, Real>(pair, max_overlap, blocks[k], pairs, contact, first, second);
    evaluate_velocities<Law, Real>(pair, dt, pairs, first, second, contact);
    const std::uint64_t difference = evaluate_law<Law, Real>(pair, dt, contact, first, &second, blocks[k], sums);
    alarms.out_of_range += in_fixed_point_range(difference) ? 0 : 1;
  }
  return alarms;
}

}  // namespace

ContactAlarms evaluate_pairs(VectorLevel level, std::span<ContactBlock> blocks, const PairParameters& pair, double dt,
                             double max_overlap, const ParticleRecord* records, ForceSum* sums) {
  return with_law(pair, [&](auto law) {
    return at_level(level, [&](auto lanes) REPOSE_INLINE {
      return evaluate_body<decltype(law), LanesOf<lanes()>>(blocks, pair, dt, max_overlap, records, sums);
    });
  });
}

}  // namespace repose
