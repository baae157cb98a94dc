#include "files/file_descriptor.h"

#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include "base/error.h"

namespace repose {

void throw_system_error(const char* action, const std::string& path) {
  const int code = errno;
  throw FileError(fmt::format("{}: cannot {}: {}", path, action, std::strerror(code)));
}

FileDescriptor::FileDescriptor(const std::string& opened, int flags, std::string path)
    : path_(std::move(path)), descriptor_(::open(opened.c_str(), flags | O_CLOEXEC, 0666)) {
  if (descriptor_ < 0) throw_system_error("open", path_);
}

FileDescriptor::~FileDescriptor() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void FileDescriptor::write(std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor_, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw_system_error("write", path_);
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

void FileDescriptor::write_at(std::string_view bytes, std::int64_t place) {
  while (!bytes.empty()) {
    const ssize_t written = ::pwrite(descriptor_, bytes.data(), bytes.size(), place);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw_system_error("write", path_);
    bytes.remove_prefix(static_cast<std::size_t>(written));
    place += written;
  }
}

void FileDescriptor::read_at(std::span<char> bytes, std::int64_t place) const {
  while (!bytes.empty()) {
    const ssize_t got = ::pread(descriptor_, bytes.data(), bytes.size(), place);
    if (got < 0 && errno == EINTR) continue;
    if (got == 0) errno = EIO;  // it has become shorter
    if (got <= 0) throw_system_error("read", path_);
    bytes = bytes.subspan(static_cast<std::size_t>(got));
    place += got;
  }
}

void FileDescriptor::sync() {
  // Some file systems know no fsync of a folder (EINVAL); then there is nothing more that could be done.
  if (::fsync(descriptor_) != 0 && errno != EINVAL) throw_system_error("sync", path_);
}

void FileDescriptor::close() {
  if (::close(std::exchange(descriptor_, -1)) != 0) throw_system_error("close", path_);
}

}  // namespace repose
