#pragma once

#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

#include "measurement/state_hash.h"
#include "simulation/simulation.h"

namespace repose::test {

/// Particles in the domain, over all ranks.
inline std::int64_t inside(const Simulation& s) {
  std::int64_t count = 0;
  for (std::size_t i = 0; i < s.particles().owned; ++i) count += is_parked(s.particles().record[i]) ? 0 : 1;
  return s.comm().sum(count);
}

/// Particles that have left by each face, over all ranks.
inline std::vector<std::int64_t> left(const Simulation& s) {
  std::vector<std::int64_t> count(s.left_here().particles.begin(), s.left_here().particles.end());
  s.comm().sum_elements(std::span(count));
  return count;
}

inline std::int64_t left_in_all(const Simulation& s) {
  const std::vector<std::int64_t> count = left(s);
  return std::accumulate(count.begin(), count.end(), std::int64_t{0});
}

inline std::string hash_of(const Simulation& s) {
  return state_hash(s.comm(), s.particles(), s.pairs(), s.wall_contacts());
}

}  // namespace repose::test
