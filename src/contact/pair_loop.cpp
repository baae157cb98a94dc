#include "contact/pair_loop.h"

#include "contact/contact_law.h"
#include "scene/particles/sphere_mass.h"

namespace repose {
namespace {

/// Asks for what a later block will read and write, a part with each quad of the present one: the processor can wait
/// for some twenty lines at once, and stands still when asked for more.
class Prefetch {
 public:
  [[gnu::always_inline]] Prefetch(std::span<const ContactBlock> blocks, const FetchView& fetch, std::size_t later,
                                  const ParticleRecord* records, const ForceSum* sums)
      : records_(records), sums_(sums) {
    if (later >= blocks.size()) return;
    line_ = reinterpret_cast<const char*>(&blocks[later]);
    particles_ = fetch.of_block(later);
  }
  [[gnu::always_inline]] void part(std::size_t k) const {
    if (line_ == nullptr) return;
    constexpr std::size_t bytes = sizeof(ContactBlock) / parts;
    for (std::size_t at = k * bytes; at < (k + 1) * bytes; at += 64) __builtin_prefetch(line_ + at, 1);
    for (std::size_t p = k * particles_.size() / parts; p < (k + 1) * particles_.size() / parts; ++p) {
      fetch_ahead(particles_[p], records_, sums_);
    }
  }

 private:
  static constexpr std::size_t parts = block_lanes / 4;
  const ParticleRecord* records_;
  const ForceSum* sums_;
  const char* line_ = nullptr;
  std::span<const std::int32_t> particles_;
};

/// The two particles of each pair, by column.
struct LanePairs {
  alignas(64) double apart[3][block_lanes], velocity[3][block_lanes];  // of the first relative to the second
  alignas(64) double first_spin[3][block_lanes], second_spin[3][block_lanes];
  alignas(64) double first_radius[block_lanes], second_radius[block_lanes];
  alignas(64) double distance[block_lanes], one_over_distance[block_lanes];
};

[[gnu::always_inline]] inline void gather_pairs(const Prefetch& prefetch, const ParticleRecord* records,
                                                const ContactBlock& block, LanePairs& pairs, LaneBody& first,
                                                LaneBody& second) {
  for (int k = 0; k < block_lanes; k += 4) {
    prefetch.part(static_cast<std::size_t>(k / 4));
    const QuadParticle a = gather(records, block.first + k);
    const QuadParticle b = gather(records, block.second + k);
    const QuadVec3 apart = a.position - b.position;
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
[[gnu::always_inline]] inline std::int64_t evaluate_overlaps(const PairParameters& pair, double max_overlap,
                                                             LanePairs& pairs, LaneGeometry& contact, LaneBody& first,
                                                             LaneBody& second) {
  const double density_first = pair.density_first;
  const double density_second = pair.density_second;
  const Quad none = {};
  QuadInt deep = {};
  for (int k = 0; k < block_lanes; k += 4) {
    const Quad a = load(pairs.first_radius + k);
    const Quad b = load(pairs.second_radius + k);
    const Quad distance = load(pairs.distance + k);
    const Quad gap = a + b - distance;
    const Quad overlap = gap > none ? gap : none;
    const Quad mass_a = sphere_mass(a, density_first);
    const Quad mass_b = sphere_mass(b, density_second);
    store(1.0 / distance, pairs.one_over_distance + k);
    store(overlap, contact.overlap + k);
    store(a * b / (a + b), contact.radius_eff + k);
    store(mass_a * mass_b / (mass_a + mass_b), contact.mass_eff + k);
    store(a - 0.5 * overlap, first.arm + k);
    store(b - 0.5 * overlap, second.arm + k);
    const Quad smaller = a < b ? a : b;
    deep += overlap > max_overlap * smaller;
  }
  return count(deep);
}

template <class Law>
[[gnu::always_inline]] inline void evaluate_velocities(const PairParameters& pair_in, double dt, const LanePairs& pairs,
                                                       const LaneBody& first, const LaneBody& second,
                                                       LaneGeometry& contact) {
  const typename Law::Parameters pair = pair_in;
  for (int k = 0; k < block_lanes; k += 4) {
    const QuadVec3 n = load(pairs.one_over_distance + k) * load(pairs.apart, k);
    const QuadVec3 v = load(pairs.velocity, k);
    const QuadVec3 spin_a = load(pairs.first_spin, k);
    const QuadVec3 spin_b = load(pairs.second_spin, k);
    const QuadVec3 n_v = Law::velocity_normal(pair, dt, load(pairs.apart, k), v, n);
    const Quad v_n = dot(v, n_v);
    const QuadVec3 turning = load(first.arm + k) * spin_a + load(second.arm + k) * spin_b;
    store(n, contact.normal, k);
    store(v_n, contact.normal_velocity + k);
    store(v - v_n * n_v - cross(turning, n_v), contact.tangential_velocity, k);
    store(without_normal_part(spin_a - spin_b, n_v), contact.rolling_velocity, k);
    if constexpr (Law::has_options) store(n_v, contact.velocity_normal, k);
  }
}

template <class Law>
[[gnu::always_inline]] inline ContactAlarms evaluate_body(std::span<ContactBlock> blocks, const FetchView& fetch,
                                                          const PairParameters& pair, double dt, double max_overlap,
                                                          const ParticleRecord* records, ForceSum* sums) {
  LanePairs pairs;
  LaneGeometry contact;
  LaneBody first, second;
  ContactAlarms alarms;
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    const Prefetch prefetch(blocks, fetch, k + 4, records, sums);
    gather_pairs(prefetch, records, blocks[k], pairs, first, second);
    alarms.too_deep += evaluate_overlaps(pair, max_overlap, pairs, contact, first, second);
    evaluate_velocities<Law>(pair, dt, pairs, first, second, contact);
    const std::uint64_t difference = evaluate_law<Law>(pair, dt, contact, first, &second, blocks[k], sums);
    alarms.out_of_range += in_fixed_point_range(difference) ? 0 : 1;
  }
  return alarms;
}

}  // namespace

ContactAlarms evaluate_pairs(VectorLevel level, std::span<ContactBlock> blocks, const FetchView& fetch,
                             const PairParameters& pair, double dt, double max_overlap, const ParticleRecord* records,
                             ForceSum* sums) {
  return with_law(pair, [&](auto law) {
    return at_level(level, [&]() REPOSE_INLINE {
      return evaluate_body<decltype(law)>(blocks, fetch, pair, dt, max_overlap, records, sums);
    });
  });
}

}  // namespace repose
