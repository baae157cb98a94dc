#include "output/agreement.h"

#include <exception>

#include "base/error.h"

namespace repose {

void agree_after(const Communicator& comm, const std::function<void()>& work) {
  bool failed = false;
  std::string message;
  try {
    work();
  } catch (const std::exception& error) {
    failed = true;
    message = error.what();
  }
  const int first_failed = comm.min(failed ? comm.rank() : comm.size());
  if (first_failed == comm.size()) return;
  comm.broadcast(message, first_failed);
  throw FileError(message);
}

void agree_after_root(const Communicator& comm, const std::function<void()>& work) {
  agree_after(comm, [&] {
    if (comm.is_root()) work();
  });
}

}  // namespace repose
