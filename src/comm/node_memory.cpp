#include "comm/node_memory.h"

#include <charconv>
#include <cstdlib>
#include <limits>
#include <string>
#include <string_view>

#include <fcntl.h>
#include <fmt/core.h>
#include <sched.h>
#include <sys/mman.h>
#include <unistd.h>

#include "base/error.h"
#include "comm/agreement.h"

namespace repose {
namespace {

std::string name_of(std::int64_t process, std::int64_t number) { return fmt::format("/repose-{}-{}", process, number); }

/// Maps `bytes` of the shared memory of a name; null when that cannot be.
std::byte* map(const std::string& name, int flags, std::size_t bytes) {
  const int file = shm_open(name.c_str(), O_RDWR | flags, S_IRUSR | S_IWUSR);
  if (file < 0) return nullptr;
  // Room that is not there shows here, not when it is written.
  const bool has_room = (flags & O_CREAT) == 0 || posix_fallocate(file, 0, static_cast<off_t>(bytes)) == 0;
  void* base = has_room ? mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0) : MAP_FAILED;
  ::close(file);
  return base == MAP_FAILED ? nullptr : static_cast<std::byte*>(base);
}

/// How many ranks may share memory. Throws DeckError when the environment says something else.
int most_ranks() {
  const char* const setting = std::getenv("REPOSE_NODE_RANKS");
  if (setting == nullptr) return std::numeric_limits<int>::max();
  const std::string_view text(setting);
  int ranks = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), ranks);
  if (error != std::errc() || rest != text.data() + text.size() || ranks < 1) {
    throw DeckError(
        fmt::format("the environment variable REPOSE_NODE_RANKS is \"{}\"; give a number of ranks from 1", text));
  }
  return ranks;
}

}  // namespace

NodeMemory::NodeMemory(const Communicator& comm) : comm_(comm), bases_(static_cast<std::size_t>(comm.size()), nullptr) {
  if (comm.size() == 1) return;
  int most = 0;
  agree_after(comm, [&] { most = most_ranks(); });
  most = comm.min(most);
  MPI_Comm node = MPI_COMM_NULL;
  check_mpi(MPI_Comm_split_type(comm.handle(), MPI_COMM_TYPE_SHARED, comm.rank(), MPI_INFO_NULL, &node),
            "MPI_Comm_split_type");
  int size = 0;
  int place = 0;
  MPI_Comm_size(node, &size);
  MPI_Comm_rank(node, &place);
  std::vector<int> ranks(static_cast<std::size_t>(size));
  const int rank = comm.rank();
  check_mpi(MPI_Allgather(&rank, 1, MPI_INT, ranks.data(), 1, MPI_INT, node), "MPI_Allgather");
  MPI_Comm_free(&node);
  for (int k = 0; k < size; ++k) {
    if (k / most == place / most) neighbours_.push_back(ranks[static_cast<std::size_t>(k)]);
  }
  if (neighbours_.size() == 1) neighbours_.clear();
  any_shares_ = comm.max(neighbours_.empty() ? 0 : 1) != 0;
}

void NodeMemory::reserve(std::size_t bytes) {
  if (!any_shares_) return;
  const auto most = static_cast<std::size_t>(comm_.max(static_cast<std::int64_t>(bytes)));
  if (most <= bytes_) return;
  close();
  bytes_ = most + most / 2;
  if (comm_.min(open() ? 1 : 0) != 0) return;
  close();
  any_shares_ = false;  // where one rank finds no room all of them send messages
}

bool NodeMemory::open() {
  static std::int64_t number = 0;
  const std::string name = name_of(getpid(), ++number);
  const auto me = static_cast<std::size_t>(comm_.rank());
  bool good = true;
  if (!neighbours_.empty()) {
    bases_[me] = map(name, O_CREAT | O_EXCL, mapped_bytes());  // begins with zeros
    good = bases_[me] != nullptr;
  }
  const std::vector<std::int64_t> processes = comm_.all_gather(static_cast<std::int64_t>(getpid()));
  const std::vector<std::int64_t> numbers = comm_.all_gather(number);
  for (const int rank : neighbours_) {
    const auto r = static_cast<std::size_t>(rank);
    if (r == me) continue;
    bases_[r] = map(name_of(processes[r], numbers[r]), 0, mapped_bytes());
    good = good && bases_[r] != nullptr;
  }
  comm_.barrier();
  if (!neighbours_.empty()) shm_unlink(name.c_str());
  return good;
}

void NodeMemory::close() {
  for (std::byte*& base : bases_) {
    if (base != nullptr) munmap(base, mapped_bytes());
    base = nullptr;
  }
}

void give_way() { sched_yield(); }

}  // namespace repose
