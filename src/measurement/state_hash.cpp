#include "measurement/state_hash.h"

#include <algorithm>
#include <array>
#include <bit>
#include <tuple>

#include <fmt/core.h>

namespace repose {
namespace {

/// Two chained 64-bit mixers with different constants (the finalisers of SplitMix64 and MurmurHash3).
struct Digest {
  std::uint64_t low = 0x243f6a8885a308d3ULL;  // digits of pi
  std::uint64_t high = 0x13198a2e03707344ULL;

  void add(std::uint64_t word) {
    low ^= word;
    low = (low ^ (low >> 30)) * 0xbf58476d1ce4e5b9ULL;
    low = (low ^ (low >> 27)) * 0x94d049bb133111ebULL;
    low ^= low >> 31;
    high += word;
    high = (high ^ (high >> 33)) * 0xff51afd7ed558ccdULL;
    high = (high ^ (high >> 33)) * 0xc4ceb9fe1a85ec53ULL;
    high ^= high >> 33;
  }
  void add(const Vec3& v) {
    for (const double component : {v.x, v.y, v.z}) add(std::bit_cast<std::uint64_t>(component));
  }
  void add(const ContactHistory& h) {
    add(h.spring);
    add(h.rolling);
  }
};

}  // namespace

std::string state_hash(const Communicator& comm, const Particles& particles, const PairLists& pairs,
                       const WallContacts& wall_contacts) {
  const Csr<PairMemory> pair_memory = pairs.memory(particles);
  const Csr<WallMemory> wall_memory = wall_contacts.memory(particles.owned);
  std::array<std::uint64_t, 2> sum = {0, 0};
  for (std::size_t i = 0; i < particles.owned; ++i) {
    const ParticleRecord& p = particles.record[i];
    if (is_parked(p)) continue;
    Digest digest;
    digest.add(static_cast<std::uint64_t>(particles.id[i]));
    digest.add(particles.position(i));
    digest.add(p.velocity);
    digest.add(p.spin);
    if (particles.has_heat) digest.add(static_cast<std::uint64_t>(particles.heat[i]));
    std::vector<PairMemory> with_particles(pair_memory.row(i).begin(), pair_memory.row(i).end());
    std::sort(with_particles.begin(), with_particles.end(),
              [](const PairMemory& a, const PairMemory& b) { return a.partner < b.partner; });
    for (const PairMemory& m : with_particles) {
      digest.add(static_cast<std::uint64_t>(m.partner));
      digest.add(m.history);
    }
    std::vector<WallMemory> with_walls(wall_memory.row(i).begin(), wall_memory.row(i).end());
    std::sort(with_walls.begin(), with_walls.end(), [](const WallMemory& a, const WallMemory& b) {
      return std::tie(a.wall, a.feature) < std::tie(b.wall, b.feature);
    });
    for (const WallMemory& m : with_walls) {
      digest.add(static_cast<std::uint64_t>(m.wall));
      digest.add(static_cast<std::uint64_t>(m.feature));
      digest.add(m.history);
    }
    sum[0] += digest.low;
    sum[1] += digest.high;
  }
  comm.sum_elements(std::span(sum.begin(), sum.end()));
  return fmt::format("{:016x}{:016x}", sum[1], sum[0]);
}

}  // namespace repose
