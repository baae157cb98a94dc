#pragma once

#include <string>

#include "files/file_descriptor.h"

namespace repose {

/// Keeps other processes that ask for it out of a folder, as long as it lives and at most as long as its process: two
/// jobs that write to the same folder would spoil each other's files. Leaves nothing behind. Where a file system has no
/// locks it does nothing. For one rank of a run.
class DirectoryLock {
 public:
  /// FileError when another process has the folder and does not let go of it for some seconds, as one that is just
  /// being ended would.
  explicit DirectoryLock(const std::string& folder);

 private:
  FileDescriptor folder_;
};

}  // namespace repose
