#pragma once

#include <string>

namespace repose {

/// Creates the folder `path` with its parents, or accepts it when it is there and can be written. Throws FileError that
/// names it and the system's reason.
void create_output_directory(const std::string& path);

}  // namespace repose
