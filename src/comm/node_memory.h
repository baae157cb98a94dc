#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "comm/communicator.h"

namespace repose {

/// Memory of each rank that the other ranks of its node read in place, and two counts of each that tell them when: how
/// often it has posted what stands there, and how often it has taken what the others had posted.
///
/// POSIX shared memory, since MPI's windows are freed by all ranks together, which an error on one of them would turn
/// into waiting for ever. Its names are gone as soon as all have opened it: a run that is killed leaves nothing
/// behind, but for one killed in that moment. Where there is no room in /dev/shm nobody is near. The environment
/// variable REPOSE_NODE_RANKS says how many ranks of a node share memory at most; 1: none.
class NodeMemory {
 public:
  /// Collective. Error on all ranks when the environment variable is no number of ranks on one of them.
  explicit NodeMemory(const Communicator& comm);
  ~NodeMemory() { close(); }
  NodeMemory(const NodeMemory&) = delete;
  NodeMemory& operator=(const NodeMemory&) = delete;

  bool is_open() const { return is_near(comm_.rank()); }
  /// Whether this rank reads the memory of another, and that one ours.
  bool is_near(int rank) const { return bases_[static_cast<std::size_t>(rank)] != nullptr; }

  /// Collective. Room for at least so many bytes of this rank. What stood there is lost when it has to grow, and who is
  /// near may change. Nobody may still read.
  void reserve(std::size_t bytes);
  std::byte* mine() { return memory_of(comm_.rank()); }
  const std::byte* of(int rank) const { return memory_of(rank); }

  std::int64_t posted(int rank) const { return count(rank, 0).load(std::memory_order_acquire); }
  std::int64_t taken(int rank) const { return count(rank, 1).load(std::memory_order_acquire); }
  void post(std::int64_t times) { count(comm_.rank(), 0).store(times, std::memory_order_release); }
  void take(std::int64_t times) { count(comm_.rank(), 1).store(times, std::memory_order_release); }

 private:
  static constexpr std::size_t line = 64;  // bytes; each count has its own, and the memory begins behind them

  std::byte* memory_of(int rank) const { return bases_[static_cast<std::size_t>(rank)] + 2 * line; }
  std::atomic_ref<std::int64_t> count(int rank, std::size_t which) const {
    return std::atomic_ref(*reinterpret_cast<std::int64_t*>(bases_[static_cast<std::size_t>(rank)] + which * line));
  }
  std::size_t mapped_bytes() const { return 2 * line + bytes_; }
  bool open();
  void close();

  const Communicator& comm_;
  std::vector<int> neighbours_;    ///< ranks of this node, this one among them; empty where it is alone
  bool any_shares_ = false;        ///< on any node; the same on all ranks
  std::vector<std::byte*> bases_;  ///< by rank; null where there is none
  std::size_t bytes_ = 0;          ///< room for each rank
};

void give_way();  ///< to other processes that want this core

/// Waits until `ready()`: a while without giving way, then letting others have the core, who may be waited for.
template <class Ready>
void wait_until(const Ready& ready) {
  for (int spins = 0; !ready(); ++spins) {
    if (spins < 1000) {
#if defined(__x86_64__)
      __builtin_ia32_pause();
#endif
    } else {
      give_way();
    }
  }
}

}  // namespace repose
