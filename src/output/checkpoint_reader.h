#pragma once

#include <string>

#include "comm/communicator.h"
#include "output/checkpoint.h"

namespace repose {

struct Checkpoint {
  CheckpointHeader header;
  Particles particles;  ///< an equal share on each rank, owned, without the scales that follow from the deck
  ContactMemory memory;
};

/// Collective. FileError on all ranks, which names the file and what is wrong, when it is damaged, no checkpoint, or
/// holds what no simulation can have: numbers that are not finite, radii that are not positive.
Checkpoint read_checkpoint(const Communicator& comm, const std::string& path);

/// The same, on one rank, for the bytes of a whole file whose seal does not matter.
Checkpoint parse_checkpoint(const Communicator& comm, const std::string& bytes, const std::string& file);

}  // namespace repose
