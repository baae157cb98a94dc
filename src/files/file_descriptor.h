#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace repose {

/// Throws FileError "<path>: cannot <action>: <the system's reason>", from errno.
[[noreturn]] void throw_system_error(const char* action, const std::string& path);

/// Owner of an open file. Failures are FileErrors that name `path`, which may differ from the name that is opened: the
/// user knows the file, not its partial name.
class FileDescriptor {
 public:
  FileDescriptor(const std::string& opened, int flags, std::string path);
  ~FileDescriptor();
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;

  int get() const { return descriptor_; }
  void write(std::string_view text);
  /// At so many bytes from the start of the file.
  void write_at(std::string_view bytes, std::int64_t place);
  /// Fills `bytes` from there; a file that ends before is an error.
  void read_at(std::span<char> bytes, std::int64_t place) const;
  void sync();
  /// Closes and reports, which the destructor cannot: some file systems tell only now that a write failed.
  void close();

 private:
  std::string path_;
  int descriptor_;
};

}  // namespace repose
