#pragma once

#include <string>

#include "comm/communicator.h"

namespace repose {

/// The bytes of a file. FileError when it cannot be read.
std::string read_whole_file(const std::string& path);

/// Collective. The text of a file, read by rank 0 alone. FileError on all ranks when it cannot be read.
std::string read_shared_file(const Communicator& comm, const std::string& path);

}  // namespace repose
