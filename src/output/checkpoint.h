#pragma once

#include <cstdint>
#include <string>

#include "comm/communicator.h"
#include "output/build_info.h"
#include "scene/particles/contact_memory.h"
#include "scene/particles/particles.h"

namespace repose {

/// In every checkpoint; the reader takes no other.
inline constexpr std::int64_t checkpoint_format = 1;

/// What a checkpoint holds beside the particles.
struct CheckpointHeader {
  std::int64_t step = 0;
  double time_s = 0.0;
  std::string deck;  ///< resolved, TOML
  BuildInfo build;
  std::string state_hash;
  std::string state;  ///< JSON (state_json.h): everything that is the same on all ranks
};

/// Collective. Writes the owned particles of all ranks with their force sums, and what their contacts remember, to
/// `path`, whole or not at all. The rows are in no order. On an error FileError on all ranks, and nothing is left
/// behind.
void write_checkpoint(const Communicator& comm, const std::string& path, const CheckpointHeader& header,
                      const Particles& particles, const ContactMemory& memory);

}  // namespace repose
