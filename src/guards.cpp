#include "guards.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace repose {
namespace {

constexpr const char* remedy =
    "shorten time.step, raise youngs_modulus, or look for grains that start inside one another";

std::string place(const Vec3& x) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", x.x, x.y, x.z); }

std::string too_deep(std::int64_t step, const std::string& what, double share, double bound, const Vec3& where) {
  return fmt::format(
      "step {}: {} overlap by {:.2f} of the smaller radius at {}, more than guards.max_overlap = {:.2f}; {}", step,
      what, share, place(where), bound, remedy);
}

}  // namespace

std::string describe_alarm(const Particles& particles, const PairLists& pairs, const WallContacts& wall_contacts,
                           std::span<const Wall> walls, double max_overlap, std::int64_t step) {
  for (std::size_t i = 0; i < particles.total(); ++i) {
    const ParticleRecord& p = particles.record[i];
    if (!std::isfinite(squared_norm(p.position) + squared_norm(p.velocity) + squared_norm(p.spin))) {
      return fmt::format("step {}: particle {} has a position, velocity or spin that is not a number; {}", step,
                         particles.id[i], remedy);
    }
  }
  for (const PairGroup& group : pairs.groups()) {
    for (const PairGroup::Pair& pair : group.pairs) {
      const auto i = static_cast<std::size_t>(pair.first);
      const auto j = static_cast<std::size_t>(pair.second);
      const ParticleRecord& a = particles.record[i];
      const ParticleRecord& b = particles.record[j];
      const double share = (a.radius + b.radius - norm(a.position - b.position)) / std::min(a.radius, b.radius);
      if (share > max_overlap) {
        return too_deep(step, fmt::format("particles {} and {}", particles.id[i], particles.id[j]), share, max_overlap,
                        particles.position(i));
      }
    }
  }
  for (const WallContact& c : wall_contacts.contacts(walls, particles)) {
    const auto i = static_cast<std::size_t>(c.particle);
    const double share = c.overlap / particles.record[i].radius;
    if (share > max_overlap) {
      const std::string& wall = walls[static_cast<std::size_t>(c.wall)].name;
      return too_deep(step, fmt::format("particle {} and wall {}", particles.id[i], wall), share, max_overlap,
                      particles.position(i));
    }
  }
  return fmt::format(
      "step {}: a contact force is beyond the range of the fixed-point sums, or a particle touches a wall in "
      "more places than can be kept; {}",
      step, remedy);
}

}  // namespace repose
