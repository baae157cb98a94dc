#pragma once

#include <cstdint>

#include <mpi.h>

#include "comm/communicator.h"

namespace repose {

/// Integers on rank 0 of a communicator, zero at first, that any rank adds to and reads while the others do something
/// else (MPI-3 one-sided). Where the network cannot do so by itself, rank 0 has to call MPI now and then: poke().
class SharedCounters {
 public:
  /// Collective, as is the destructor.
  SharedCounters(const Communicator& comm, int count);
  ~SharedCounters();
  SharedCounters(const SharedCounters&) = delete;
  SharedCounters& operator=(const SharedCounters&) = delete;

  /// Adds and returns what was there before.
  std::int64_t add(int which, std::int64_t value);
  std::int64_t read(int which) { return add(which, 0); }
  /// Lets MPI answer other ranks.
  void poke() const;

 private:
  const Communicator& comm_;
  std::int64_t* memory_ = nullptr;
  MPI_Win window_ = MPI_WIN_NULL;
};

}  // namespace repose
