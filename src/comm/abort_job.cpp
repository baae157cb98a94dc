#include "comm/abort_job.h"

#include <cstdio>
#include <cstdlib>

#include <fmt/core.h>

namespace repose {

void abort_job(const Communicator& comm, const std::string& what) {
  fmt::print(stderr, "repose: rank {}: {}\n", comm.rank(), what);
  if (comm.handle() != MPI_COMM_NULL) MPI_Abort(MPI_COMM_WORLD, 1);
  std::exit(1);
}

}  // namespace repose
