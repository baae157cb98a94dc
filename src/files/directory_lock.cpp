#include "files/directory_lock.h"

#include <cerrno>
#include <chrono>
#include <thread>

#include <fcntl.h>
#include <sys/file.h>

#include "base/error.h"
#include "base/wall_clock.h"

namespace repose {

DirectoryLock::DirectoryLock(const std::string& folder) : folder_(folder, O_RDONLY | O_DIRECTORY, folder) {
  constexpr double patience = 5.0;  // s
  const WallClock::time_point start = WallClock::now();
  while (::flock(folder_.get(), LOCK_EX | LOCK_NB) != 0) {
    if (errno != EWOULDBLOCK && errno != EINTR) return;  // no locks here
    if (seconds_since(start) > patience) {
      throw FileError(folder + ": another run is at work in this directory; wait for it or end it");
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
}

}  // namespace repose
