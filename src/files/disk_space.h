#pragma once

#include <cstdint>
#include <string>

namespace repose {

enum class FileSize { grown, kept };

/// Sets aside `bytes` for the file `opened`, so that later writes cannot meet a full disk; where a file system cannot
/// do that, checks its free space. Keeps what the file holds, creates it if need be. `grown` makes the file so long,
/// which limits of users and file systems may forbid; `kept` leaves its length. Throws FileError with the name `path`
/// and the system's reason.
void reserve_space(const std::string& opened, std::int64_t bytes, const std::string& path,
                   FileSize size = FileSize::grown);

/// Gives back what has been set aside behind the end of the file.
void release_space(const std::string& opened, const std::string& path);

}  // namespace repose
