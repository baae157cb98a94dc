#include "contact/pair_loop.h"

#include "contact/lanes.h"
#include "scene/sphere.h"

namespace repose {
namespace {

/// Asks for what a later block will read and write, a part with each quad of the present one: the processor can wait
/// for some twenty lines at once, and stands still when asked for more.
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
      const auto* record = reinterpret_cast<const char*>(records_ + particles_[p]);
      __builtin_prefetch(record);
      __builtin_prefetch(record + 64);
      __builtin_prefetch(sums_ + particles_[p], 1);
    }
  }

 private:
  static constexpr std::size_t parts = block_lanes / 4;
  const ParticleRecord* records_;
  const ForceSum* sums_;
  const char* line_ = nullptr;
  std::span<const std::int32_t> particles_;
};

/// Gathers the particles of a block and evaluates where and how they meet. Returns the number of contacts deeper than
/// `max_overlap` times the smaller radius.
[[gnu::always_inline]] inline std::int64_t evaluate_geometry(const Prefetch& prefetch, const ParticleRecord* records,
                                                             const ContactBlock& block, const PairParameters& pair,
                                                             double max_overlap, LaneGeometry& contact, LaneBody& first,
                                                             LaneBody& second) {
  const double density_first = pair.density_first;
  const double density_second = pair.density_second;
  const Quad none = {};
  QuadInt deep = {};
  for (int k = 0; k < block_lanes; k += 4) {
    prefetch.part(static_cast<std::size_t>(k / 4));
    const QuadParticle a = gather(records, block.first + k);
    const QuadParticle b = gather(records, block.second + k);
    const QuadVec3 d = a.position - b.position;
    const Quad distance = square_root(dot(d, d));
    const Quad gap = a.radius + b.radius - distance;
    const Quad overlap = gap > none ? gap : none;
    const QuadVec3 n = (1.0 / distance) * d;
    const Quad arm_a = a.radius - 0.5 * overlap;
    const Quad arm_b = b.radius - 0.5 * overlap;
    const Quad mass_a = sphere_mass(a.radius, density_first);
    const Quad mass_b = sphere_mass(b.radius, density_second);
    const QuadVec3 v = a.velocity - b.velocity;
    const Quad v_n = dot(v, n);

    contact.set(k, {.normal = n,
                    .overlap = overlap,
                    .radius_eff = a.radius * b.radius / (a.radius + b.radius),
                    .mass_eff = mass_a * mass_b / (mass_a + mass_b),
                    .normal_velocity = v_n,
                    .tangential_velocity = v - v_n * n - cross(arm_a * a.spin + arm_b * b.spin, n),
                    .rolling_velocity = without_normal_part(a.spin - b.spin, n)});
    first.set(k, arm_a, a);
    second.set(k, arm_b, b);
    const Quad smaller = a.radius < b.radius ? a.radius : b.radius;
    deep += overlap > max_overlap * smaller;
  }
  return count(deep);
}

[[gnu::always_inline]] inline ContactAlarms evaluate_body(std::span<ContactBlock> blocks, const FetchList& fetch,
                                                          const PairParameters& pair, double dt, double max_overlap,
                                                          const ParticleRecord* records, ForceSum* sums) {
  LaneGeometry contact;
  LaneBody first, second;
  ContactAlarms alarms;
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    const Prefetch prefetch(blocks, fetch, k + 2, records, sums);
    alarms.too_deep += evaluate_geometry(prefetch, records, blocks[k], pair, max_overlap, contact, first, second);
    const std::uint64_t difference = evaluate_law(pair, dt, contact, first, &second, blocks[k], sums);
    alarms.out_of_range += in_fixed_point_range(difference) ? 0 : 1;
  }
  return alarms;
}

}  // namespace

ContactAlarms evaluate_pairs(VectorLevel level, std::span<ContactBlock> blocks, const FetchList& fetch,
                             const PairParameters& pair, double dt, double max_overlap, const ParticleRecord* records,
                             ForceSum* sums) {
  return at_level(level,
                  [&]() REPOSE_INLINE { return evaluate_body(blocks, fetch, pair, dt, max_overlap, records, sums); });
}

}  // namespace repose
