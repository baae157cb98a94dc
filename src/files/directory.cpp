#include "files/directory.h"

#include <filesystem>
#include <system_error>

#include <fmt/core.h>

#include "base/error.h"
#include "files/atomic_file.h"

namespace repose {

void create_output_directory(const std::string& path) {
  if (path.empty()) throw FileError("--output \"\": names no folder");
  std::error_code reason;
  std::filesystem::create_directories(path, reason);
  if (!std::filesystem::is_directory(path)) {
    const bool taken = std::filesystem::exists(std::filesystem::symlink_status(path));
    throw FileError(fmt::format("{}: cannot create the output folder: {}", path,
                                taken ? "a file of this name is in the way" : reason.message()));
  }
  // Permission bits tell little (root, read-only mounts, quotas): only a file that was written proves it.
  const std::string probe = (std::filesystem::path(path) / ".repose-write-test").string();
  write_text_file(probe, "\n");
  std::filesystem::remove(probe, reason);
}

}  // namespace repose
