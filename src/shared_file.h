#pragma once

#include <string>

#include "comm/communicator.h"

namespace repose {

/// Collective. The text of a regular file, read by rank 0 alone. FileError on all ranks when it cannot be read, or is a
/// directory, a pipe or a device.
std::string read_shared_file(const Communicator& comm, const std::string& path);

}  // namespace repose
