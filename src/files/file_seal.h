#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "comm/communicator.h"

/// The seal of the HDF5 files that repose writes: their first 512 bytes, which HDF5 leaves to the user, hold a line of
/// text with the length of the file and the CRC-32 of everything behind them, and zeros. A file that is cut off or
/// damaged anywhere is found out before HDF5 sees it.
namespace repose {

inline constexpr std::size_t seal_bytes = 512;

/// Collective. Seals the complete file `opened`, of which every rank reads a part. FileError, with the name `path`, on
/// all ranks when it cannot be read or written.
void seal_file(const Communicator& comm, const std::string& opened, const std::string& path);

/// Collective. FileError on all ranks, which names the file and what is wrong with it, unless its seal is whole.
void check_seal(const Communicator& comm, const std::string& path);

/// The same for the bytes of a whole file, on one rank; a file without a seal (not written by repose) passes.
void check_seal_if_any(std::string_view bytes, const std::string& path);

}  // namespace repose
