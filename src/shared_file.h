#pragma once

#include <string>

#include "comm/communicator.h"

namespace repose {

/// Collective. The text of a file, read by rank 0 alone. FileError on all ranks when it cannot be read.
std::string read_shared_file(const Communicator& comm, const std::string& path);

}  // namespace repose
