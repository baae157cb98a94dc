#include "files/shared_file.h"

#include <array>
#include <cerrno>
#include <filesystem>
#include <new>

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/error.h"
#include "comm/agreement.h"
#include "files/file_descriptor.h"

namespace repose {

namespace {

/// A pipe or a device might never end, and need not give the same twice.
void refuse_what_is_no_file(const FileDescriptor& file, const std::string& path) {
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) throw_system_error("read", path);
  if (S_ISREG(status.st_mode)) return;
  throw FileError(fmt::format("{}: is {}, a regular file was expected", path,
                              S_ISDIR(status.st_mode)    ? "a directory"
                              : S_ISFIFO(status.st_mode) ? "a pipe"
                                                         : "a device"));
}

std::string read_file(const std::string& path) {
  const FileDescriptor file(path, O_RDONLY | O_NONBLOCK, path);  // a pipe without a writer would be waited for
  refuse_what_is_no_file(file, path);
  std::string text;
  std::array<char, 65536> part{};
  while (true) {
    const ssize_t size = ::read(file.get(), part.data(), part.size());
    if (size < 0 && errno == EINTR) continue;
    if (size < 0) throw_system_error("read", path);
    if (size == 0) return text;
    text.append(part.data(), static_cast<std::size_t>(size));
  }
}

}  // namespace

std::string read_whole_file(const std::string& path) {
  try {
    return read_file(path);
  } catch (const std::bad_alloc&) {
    throw FileError(path + ": does not fit into the memory");
  }
}

std::string read_shared_file(const Communicator& comm, const std::string& path) {
  std::string text;
  agree_after_root(comm, [&] { text = read_whole_file(path); });
  comm.broadcast(text);
  return text;
}

std::string path_beside(const std::string& deck_path, const std::string& file) {
  return (std::filesystem::path(deck_path).parent_path() / file).string();
}

ReadFile reader_beside(const Communicator& comm, const std::string& deck_path) {
  return [&comm, deck_path](const std::string& file) { return read_shared_file(comm, path_beside(deck_path, file)); };
}

}  // namespace repose
