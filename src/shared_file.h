#pragma once

#include <string>

#include "comm/communicator.h"

namespace repose {

/// The bytes of a regular file. FileError when it cannot be read, or is a directory, a pipe or a device.
std::string read_whole_file(const std::string& path);

/// Collective. The same, read by rank 0 alone; FileError on all ranks.
std::string read_shared_file(const Communicator& comm, const std::string& path);

}  // namespace repose
