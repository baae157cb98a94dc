#pragma once

#include <cstdint>
#include <string>

namespace repose {

/// Makes the file `opened` `bytes` long with space that the file system has set aside, so that later writes cannot meet
/// a full disk; where a file system cannot do that, checks its free space. Keeps what the file holds, creates it if
/// need be. Throws FileError with the name `path` and the system's reason.
void reserve_space(const std::string& opened, std::int64_t bytes, const std::string& path);

}  // namespace repose
