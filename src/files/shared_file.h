#pragma once

#include <string>

#include "comm/communicator.h"
#include "files/read_file.h"

namespace repose {

/// The bytes of a regular file. FileError when it cannot be read, or is a directory, a pipe or a device.
std::string read_whole_file(const std::string& path);

/// Collective. The same, read by rank 0 alone; FileError on all ranks.
std::string read_shared_file(const Communicator& comm, const std::string& path);

/// Where a file is that a deck names, relative to the deck.
std::string path_beside(const std::string& deck_path, const std::string& file);

/// Reads the files that a deck names, relative to the deck, by read_shared_file. Refers to the communicator.
ReadFile reader_beside(const Communicator& comm, const std::string& deck_path);

}  // namespace repose
