#include "files/atomic_file.h"

#include <cstdio>
#include <filesystem>

#include <fcntl.h>
#include <unistd.h>

#include "base/error.h"
#include "files/file_descriptor.h"

namespace repose {

namespace {

void sync_path(const std::string& opened, int flags, const std::string& path) {
  FileDescriptor file(opened, flags, path);
  file.sync();
  file.close();
}

}  // namespace

std::string partial_path(const std::string& path) { return path + ".partial"; }

void refuse_special_file(const std::string& path) {
  std::error_code reason;
  const auto status = std::filesystem::status(path, reason);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    throw FileError(path + ": cannot replace: not a regular file");
  }
}

void publish_file(const std::string& path) {
  refuse_special_file(path);
  const std::string partial = partial_path(path);
  sync_path(partial, O_RDONLY, path);
  if (std::rename(partial.c_str(), path.c_str()) != 0)
    throw_system_error("rename the finished file to this name", path);
  const std::string folder = std::filesystem::path(path).parent_path().string();
  sync_path(folder.empty() ? "." : folder, O_RDONLY | O_DIRECTORY, path);
}

void discard_partial_file(const std::string& path) noexcept { ::unlink((path + ".partial").c_str()); }

void write_text_file(const std::string& path, std::string_view text) {
  refuse_special_file(path);
  try {
    FileDescriptor file(partial_path(path), O_WRONLY | O_CREAT | O_TRUNC, path);
    file.write(text);
    file.close();
    publish_file(path);
  } catch (...) {
    discard_partial_file(path);
    throw;
  }
}

}  // namespace repose
