#pragma once

#include <array>
#include <cstdint>

namespace repose {

/// Philox4x32-10, a counter-based random number generator: four random words from a counter and a key, without state.
/// Salmon, Moraes, Dror, Shaw, "Parallel random numbers: as easy as 1, 2, 3", SC'11, doi:10.1145/2063384.2063405.
constexpr std::array<std::uint32_t, 4> philox4x32(std::array<std::uint32_t, 4> counter,
                                                  std::array<std::uint32_t, 2> key) {
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t product0 = std::uint64_t{0xD2511F53} * counter[0];
    const std::uint64_t product1 = std::uint64_t{0xCD9E8D57} * counter[2];
    counter = {static_cast<std::uint32_t>(product1 >> 32) ^ counter[1] ^ key[0], static_cast<std::uint32_t>(product1),
               static_cast<std::uint32_t>(product0 >> 32) ^ counter[3] ^ key[1], static_cast<std::uint32_t>(product0)};
    key[0] += 0x9E3779B9;
    key[1] += 0xBB67AE85;
  }
  return counter;
}

/// What a random number is drawn for; each use has its own stream.
enum class RandomStream : std::uint32_t {
  insertion_jitter = 0,
  particle_size = 1,
  fill_position = 2,
  pour_position = 3,
  start_design = 4,
  morris_design = 5,
  posterior = 6,
  transient_noise = 16
};

/// The k-th number of a particle in a stream, uniform in [0, 1) with 53 bits. A function of its arguments alone, so
/// that it does not depend on the decomposition.
constexpr double uniform(std::uint64_t seed, std::uint64_t id, RandomStream stream, std::uint32_t k) {
  const auto word = philox4x32(
      {static_cast<std::uint32_t>(id), static_cast<std::uint32_t>(id >> 32), static_cast<std::uint32_t>(stream), k},
      {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)});
  const std::uint64_t bits = (std::uint64_t{word[0]} << 21) ^ (word[1] >> 11);
  return static_cast<double>(bits) * 0x1p-53;
}

}  // namespace repose
