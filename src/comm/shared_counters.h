#pragma once

#include <cstdint>
#include <vector>

#include <mpi.h>

#include "comm/communicator.h"

namespace repose {

/// Integers on rank 0 of a communicator, zero at first, that any rank adds to and reads while the others do something
/// else. Rank 0 has to call answer() now and then: these are plain messages, since not every MPI library has one-sided
/// ones between its nodes.
class SharedCounters {
 public:
  /// Collective, as is the destructor, which answers what is still asked.
  SharedCounters(const Communicator& comm, int count);
  ~SharedCounters();
  SharedCounters(const SharedCounters&) = delete;
  SharedCounters& operator=(const SharedCounters&) = delete;

  /// Adds and returns what was there before; waits for rank 0.
  std::int64_t add(int which, std::int64_t value);
  std::int64_t read(int which) { return add(which, 0); }
  /// The value of a while ago, zero at first. Waits for nobody: what it asks for is returned by a later call.
  std::int64_t recent(int which);
  /// On rank 0: answers what the others have asked.
  void answer();

 private:
  struct Recent {
    MPI_Request reply = MPI_REQUEST_NULL;
    std::int64_t next = 0;  ///< is received here
    std::int64_t value = 0;
  };

  /// Asks rank 0; the answer comes into `before`.
  MPI_Request ask(int which, std::int64_t value, int reply_tag, std::int64_t& before);

  const Communicator comm_;
  std::vector<std::int64_t> values_;  ///< on rank 0
  std::vector<Recent> recent_;
  std::int64_t asked_ = 0;
  std::int64_t answered_ = 0;
};

}  // namespace repose
