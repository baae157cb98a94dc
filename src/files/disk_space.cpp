#include "files/disk_space.h"

#include <cerrno>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include "files/file_descriptor.h"

namespace repose {

namespace {

void check_free_space(const FileDescriptor& file, std::int64_t bytes, const std::string& path) {
  struct statvfs status {};
  if (::fstatvfs(file.get(), &status) != 0) throw_system_error("reserve space", path);
  // Some network file systems report no sizes at all.
  if (status.f_blocks == 0 || status.f_bavail >= static_cast<std::uint64_t>(bytes) / status.f_frsize + 1) return;
  errno = ENOSPC;
  throw_system_error("reserve space", path);
}

}  // namespace

void reserve_space(const std::string& opened, std::int64_t bytes, const std::string& path, FileSize size) {
  FileDescriptor file(opened, O_WRONLY | O_CREAT, path);
  const int mode = size == FileSize::kept ? FALLOC_FL_KEEP_SIZE : 0;
  int code = 0;
  do {
    code =
        ::fallocate(file.get(), mode, 0, bytes);  // not posix_fallocate, which would write zeros where this is unknown
  } while (code != 0 && errno == EINTR);
  if (code != 0 && errno != EOPNOTSUPP && errno != ENOSYS) throw_system_error("reserve space", path);
  if (code != 0) check_free_space(file, bytes, path);
  file.close();
}

void release_space(const std::string& opened, const std::string& path) {
  FileDescriptor file(opened, O_WRONLY, path);
  struct stat status {};
  if (::fstat(file.get(), &status) != 0 || ::ftruncate(file.get(), status.st_size) != 0) {
    throw_system_error("cut to its length", path);
  }
  file.close();
}

}  // namespace repose
