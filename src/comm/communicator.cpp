#include "comm/communicator.h"

#include <algorithm>
#include <stdexcept>

namespace repose {
namespace {

/// Calls visit(begin, count) for the pieces of `length` bytes.
template <class Visit>
void for_each_piece(std::size_t length, std::size_t piece, const Visit& visit) {
  for (std::size_t begin = 0; begin < length; begin += piece) {
    visit(begin, static_cast<int>(std::min(piece, length - begin)));
  }
}

}  // namespace

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

Communicator::Communicator(const Communicator& parent, int group) {
  check_mpi(MPI_Comm_split(parent.comm_, group, parent.rank_, &comm_), "MPI_Comm_split");
  MPI_Comm_set_errhandler(comm_, MPI_ERRORS_RETURN);
  MPI_Comm_rank(comm_, &rank_);
  MPI_Comm_size(comm_, &size_);
}

Communicator::~Communicator() {
  if (!is_self()) MPI_Comm_free(&comm_);
}

std::int64_t Communicator::exclusive_sum(std::int64_t value) const {
  if (is_self()) return 0;
  std::int64_t below = 0;
  ++traffic_.collectives;
  check_mpi(MPI_Exscan(&value, &below, 1, MPI_INT64_T, MPI_SUM, comm_), "MPI_Exscan");
  return rank_ == 0 ? 0 : below;  // MPI leaves rank 0 undefined
}

void Communicator::broadcast(std::string& text, int root, std::size_t piece) const {
  if (is_self()) return;
  auto length = static_cast<std::int64_t>(text.size());
  broadcast(length, root);
  text.resize(static_cast<std::size_t>(length));
  for_each_piece(text.size(), piece, [&](std::size_t begin, int count) {
    ++traffic_.collectives;
    check_mpi(MPI_Bcast(text.data() + begin, count, MPI_CHAR, root, comm_), "MPI_Bcast");
  });
}

std::vector<std::vector<char>> Communicator::exchange(const std::vector<std::vector<char>>& send,
                                                      std::size_t piece) const {
  if (is_self()) return send;
  const auto ranks = static_cast<std::size_t>(size_);
  std::vector<std::int64_t> send_bytes(ranks);
  std::vector<std::int64_t> receive_bytes(ranks);
  for (std::size_t r = 0; r < ranks; ++r) send_bytes[r] = std::ssize(send[r]);
  ++traffic_.collectives;
  check_mpi(MPI_Alltoall(send_bytes.data(), 1, MPI_INT64_T, receive_bytes.data(), 1, MPI_INT64_T, comm_),
            "MPI_Alltoall");

  // The pieces from one rank to another arrive in the order in which they are sent (MPI's rule for equal tags).
  std::vector<std::vector<char>> received(ranks);
  std::vector<MPI_Request> requests;
  constexpr int tag = 1;
  for (std::size_t r = 0; r < ranks; ++r) {
    if (static_cast<int>(r) == rank_) {
      received[r] = send[r];
      continue;
    }
    received[r].resize(static_cast<std::size_t>(receive_bytes[r]));
    for_each_piece(received[r].size(), piece, [&](std::size_t begin, int count) {
      check_mpi(MPI_Irecv(received[r].data() + begin, count, MPI_CHAR, static_cast<int>(r), tag, comm_,
                          &requests.emplace_back()),
                "MPI_Irecv");
    });
  }
  for (std::size_t r = 0; r < ranks; ++r) {
    if (static_cast<int>(r) == rank_) continue;
    for_each_piece(send[r].size(), piece, [&](std::size_t begin, int count) {
      count_sent(1, count);
      check_mpi(
          MPI_Isend(send[r].data() + begin, count, MPI_CHAR, static_cast<int>(r), tag, comm_, &requests.emplace_back()),
          "MPI_Isend");
    });
  }
  check_mpi(MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE), "MPI_Waitall");
  return received;
}

}  // namespace repose
