#include "comm/shared_counters.h"

namespace repose {

SharedCounters::SharedCounters(const Communicator& comm, int count) : comm_(comm) {
  const MPI_Aint bytes = comm.is_root() ? count * static_cast<MPI_Aint>(sizeof(std::int64_t)) : 0;
  check_mpi(MPI_Win_allocate(bytes, sizeof(std::int64_t), MPI_INFO_NULL, comm.handle(), &memory_, &window_),
            "MPI_Win_allocate");
  check_mpi(MPI_Win_lock_all(0, window_), "MPI_Win_lock_all");
  if (comm.is_root()) {
    for (int i = 0; i < count; ++i) memory_[i] = 0;
  }
  MPI_Win_sync(window_);
  comm.barrier();
}

SharedCounters::~SharedCounters() {
  MPI_Win_unlock_all(window_);
  MPI_Win_free(&window_);
}

std::int64_t SharedCounters::add(int which, std::int64_t value) {
  std::int64_t before = 0;
  check_mpi(MPI_Fetch_and_op(&value, &before, MPI_INT64_T, 0, which, value == 0 ? MPI_NO_OP : MPI_SUM, window_),
            "MPI_Fetch_and_op");
  check_mpi(MPI_Win_flush(0, window_), "MPI_Win_flush");
  return before;
}

void SharedCounters::poke() const {
  int found = 0;
  check_mpi(MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, comm_.handle(), &found, MPI_STATUS_IGNORE), "MPI_Iprobe");
}

}  // namespace repose
