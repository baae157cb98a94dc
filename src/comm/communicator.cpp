#include "comm/communicator.h"

#include <algorithm>
#include <stdexcept>

namespace repose {

MpiGuard::MpiGuard(int* argc, char*** argv) { MPI_Init(argc, argv); }
MpiGuard::~MpiGuard() { MPI_Finalize(); }

void check_mpi(int code, const char* call) {
  if (code == MPI_SUCCESS) return;
  char text[MPI_MAX_ERROR_STRING];
  int length = 0;
  MPI_Error_string(code, text, &length);
  throw std::runtime_error(std::string(call) + ": " + std::string(text, static_cast<std::size_t>(length)));
}

Communicator::Communicator(MPI_Comm parent) {
  check_mpi(MPI_Comm_dup(parent, &comm_), "MPI_Comm_dup");
  MPI_Comm_set_errhandler(comm_, MPI_ERRORS_RETURN);
  MPI_Comm_rank(comm_, &rank_);
  MPI_Comm_size(comm_, &size_);
}

Communicator::~Communicator() { MPI_Comm_free(&comm_); }

std::int64_t Communicator::exclusive_sum(std::int64_t value) const {
  std::int64_t below = 0;
  check_mpi(MPI_Exscan(&value, &below, 1, MPI_INT64_T, MPI_SUM, comm_), "MPI_Exscan");
  return rank_ == 0 ? 0 : below;  // MPI leaves rank 0 undefined
}

void Communicator::broadcast(std::string& text, int root) const {
  auto length = static_cast<std::int64_t>(text.size());
  broadcast(length, root);
  text.resize(static_cast<std::size_t>(length));
  constexpr std::int64_t most = std::int64_t{1} << 30;  // MPI counts by int
  for (std::int64_t begin = 0; begin < length; begin += most) {
    const auto count = static_cast<int>(std::min(most, length - begin));
    check_mpi(MPI_Bcast(text.data() + begin, count, MPI_CHAR, root, comm_), "MPI_Bcast");
  }
}

std::vector<std::vector<char>> Communicator::exchange(const std::vector<std::vector<char>>& send) const {
  const auto ranks = static_cast<std::size_t>(size_);
  std::vector<int> send_counts(ranks);
  std::vector<int> receive_counts(ranks);
  for (std::size_t r = 0; r < ranks; ++r) send_counts[r] = static_cast<int>(send[r].size());
  check_mpi(MPI_Alltoall(send_counts.data(), 1, MPI_INT, receive_counts.data(), 1, MPI_INT, comm_), "MPI_Alltoall");

  std::vector<std::vector<char>> received(ranks);
  std::vector<MPI_Request> requests;
  constexpr int tag = 1;
  for (std::size_t r = 0; r < ranks; ++r) {
    received[r].resize(static_cast<std::size_t>(receive_counts[r]));
    if (static_cast<int>(r) == rank_) {
      std::copy(send[r].begin(), send[r].end(), received[r].begin());
    } else if (receive_counts[r] > 0) {
      check_mpi(MPI_Irecv(received[r].data(), receive_counts[r], MPI_CHAR, static_cast<int>(r), tag, comm_,
                          &requests.emplace_back()),
                "MPI_Irecv");
    }
  }
  for (std::size_t r = 0; r < ranks; ++r) {
    if (static_cast<int>(r) == rank_ || send_counts[r] == 0) continue;
    check_mpi(
        MPI_Isend(send[r].data(), send_counts[r], MPI_CHAR, static_cast<int>(r), tag, comm_, &requests.emplace_back()),
        "MPI_Isend");
  }
  check_mpi(MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE), "MPI_Waitall");
  return received;
}

}  // namespace repose
