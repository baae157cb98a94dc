#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include <mpi.h>

namespace repose {

/// MPI_Init and MPI_Finalize as a scope.
class MpiGuard {
 public:
  MpiGuard(int* argc, char*** argv);
  ~MpiGuard();
  MpiGuard(const MpiGuard&) = delete;
  MpiGuard& operator=(const MpiGuard&) = delete;
};

template <class T>
MPI_Datatype mpi_type();
template <>
inline MPI_Datatype mpi_type<char>() {
  return MPI_CHAR;
}
template <>
inline MPI_Datatype mpi_type<int>() {
  return MPI_INT;
}
template <>
inline MPI_Datatype mpi_type<std::int64_t>() {
  return MPI_INT64_T;
}
template <>
inline MPI_Datatype mpi_type<std::uint64_t>() {
  return MPI_UINT64_T;
}
template <>
inline MPI_Datatype mpi_type<double>() {
  return MPI_DOUBLE;
}

/// Throws std::runtime_error with MPI's own text when `code` is not MPI_SUCCESS.
void check_mpi(int code, const char* call);

/// What a rank has sent to others, and the collective calls it has taken part in.
struct Traffic {
  std::int64_t messages = 0;
  std::int64_t bytes = 0;  ///< of the messages
  std::int64_t collectives = 0;
};

/// A duplicate of an MPI communicator, or a part of another one, freed with the object. Every member but rank, size,
/// handle and traffic is collective.
class Communicator {
 public:
  explicit Communicator(MPI_Comm parent);
  /// This process alone, also where MPI has not been started: it calls nothing of MPI, has no handle and no parts.
  static Communicator self() { return {}; }
  /// The ranks of `parent` that give the same group (at least 0), in their order there.
  Communicator(const Communicator& parent, int group);
  ~Communicator();
  Communicator(const Communicator&) = delete;
  Communicator& operator=(const Communicator&) = delete;

  int rank() const { return rank_; }
  int size() const { return size_; }
  bool is_root() const { return rank_ == 0; }
  MPI_Comm handle() const { return comm_; }
  /// Of this object so far: a count for the summary, on which nothing else depends.
  const Traffic& traffic() const { return traffic_; }
  /// Adds what was sent through the handle.
  void count_sent(std::int64_t messages, std::int64_t bytes) const {
    traffic_.messages += messages;
    traffic_.bytes += bytes;
  }

  template <class T>
  T sum(T value) const {
    return reduce(value, MPI_SUM);
  }
  template <class T>
  T max(T value) const {
    return reduce(value, MPI_MAX);
  }
  template <class T>
  T min(T value) const {
    return reduce(value, MPI_MIN);
  }
  /// Element by element over the ranks, in place; all ranks pass the same length.
  template <class T>
  void sum_elements(std::span<T> values) const {
    reduce(values, MPI_SUM);
  }
  template <class T>
  void max_elements(std::span<T> values) const {
    reduce(values, MPI_MAX);
  }
  /// Bits that any rank has set.
  void or_elements(std::span<std::uint64_t> values) const { reduce(values, MPI_BOR); }
  /// Sum over the ranks below this one.
  std::int64_t exclusive_sum(std::int64_t value) const;

  template <class T>
  std::vector<T> all_gather(T value) const {
    if (is_self()) return {value};
    std::vector<T> all(static_cast<std::size_t>(size_));
    ++traffic_.collectives;
    check_mpi(MPI_Allgather(&value, 1, mpi_type<T>(), all.data(), 1, mpi_type<T>(), comm_), "MPI_Allgather");
    return all;
  }
  /// The values of all ranks, in rank order, on rank 0; empty elsewhere.
  template <class T>
  std::vector<T> gather(const std::vector<T>& mine) const;

  template <class T>
  void broadcast(T& value, int root = 0) const {
    if (is_self()) return;
    ++traffic_.collectives;
    check_mpi(MPI_Bcast(&value, 1, mpi_type<T>(), root, comm_), "MPI_Bcast");
  }
  /// Of any length; the other ranks need not know it.
  template <class T>
  void broadcast(std::vector<T>& values, int root = 0) const;
  /// MPI counts in 32 bits: what is longer than `piece` bytes travels in pieces.
  static constexpr std::size_t longest_piece = std::size_t{1} << 30;
  void broadcast(std::string& text, int root = 0, std::size_t piece = longest_piece) const;

  /// Sends send[r] to rank r; returns what every rank sent here, one vector per source.
  std::vector<std::vector<char>> exchange(const std::vector<std::vector<char>>& send,
                                          std::size_t piece = longest_piece) const;

  void barrier() const {
    if (is_self()) return;
    ++traffic_.collectives;
    check_mpi(MPI_Barrier(comm_), "MPI_Barrier");
  }

 private:
  Communicator() = default;
  bool is_self() const { return comm_ == MPI_COMM_NULL; }

  template <class T>
  T reduce(T value, MPI_Op op) const {
    reduce(std::span<T>(&value, 1), op);
    return value;
  }
  template <class T>
  void reduce(std::span<T> values, MPI_Op op) const {
    if (is_self()) return;
    ++traffic_.collectives;
    check_mpi(MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), mpi_type<T>(), op, comm_),
              "MPI_Allreduce");
  }

  MPI_Comm comm_ = MPI_COMM_NULL;
  int rank_ = 0;
  int size_ = 1;
  mutable Traffic traffic_;
};

template <class T>
void Communicator::broadcast(std::vector<T>& values, int root) const {
  static_assert(std::is_trivially_copyable_v<T>);
  std::string bytes(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
  broadcast(bytes, root);
  values.resize(bytes.size() / sizeof(T));
  if (!bytes.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
}

/// Collective. A barrier that can be asked whether all ranks have come to it, instead of holding this one.
class PatientBarrier {
 public:
  explicit PatientBarrier(const Communicator& comm) {
    check_mpi(MPI_Ibarrier(comm.handle(), &request_), "MPI_Ibarrier");
  }
  /// To be asked until it is true.
  bool passed() {
    int done = 0;
    check_mpi(MPI_Test(&request_, &done, MPI_STATUS_IGNORE), "MPI_Test");
    return done != 0;
  }

 private:
  MPI_Request request_ = MPI_REQUEST_NULL;
};

template <class T>
std::vector<T> Communicator::gather(const std::vector<T>& mine) const {
  std::vector<std::vector<char>> send(static_cast<std::size_t>(size_));
  const auto* bytes = reinterpret_cast<const char*>(mine.data());
  send[0].assign(bytes, bytes + mine.size() * sizeof(T));
  std::vector<T> all;
  for (const std::vector<char>& part : exchange(send)) {
    const std::size_t before = all.size();
    all.resize(before + part.size() / sizeof(T));
    if (!part.empty()) std::memcpy(all.data() + before, part.data(), part.size());
  }
  return all;
}

}  // namespace repose
