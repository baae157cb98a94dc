// The memory that the ranks of a node read in place.
#include "comm/node_memory.h"

#include <cstring>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/error.h"
#include "node_ranks.h"

namespace repose::test {
namespace {

class NodeMemoryOf : public ::testing::Test {
 protected:
  const Communicator world{MPI_COMM_WORLD};

  /// Each writes what says who and when, and reads that of all others.
  void pass_round(NodeMemory& memory, std::int64_t time) const {
    for (int rank = 0; rank < world.size(); ++rank) {
      if (memory.is_near(rank)) wait_until([&] { return memory.taken(rank) >= time - 1; });
    }
    const std::int64_t mine = 1000 * time + world.rank();
    std::memcpy(memory.mine(), &mine, sizeof mine);
    memory.post(time);
    for (int rank = 0; rank < world.size(); ++rank) {
      if (!memory.is_near(rank)) continue;
      wait_until([&] { return memory.posted(rank) >= time; });
      std::int64_t theirs = 0;
      std::memcpy(&theirs, memory.of(rank), sizeof theirs);
      EXPECT_EQ(theirs, 1000 * time + rank);
    }
    memory.take(time);
  }
};

TEST_F(NodeMemoryOf, AllRanksIsReadByAllWithoutWaitingInBetween) {
  NodeMemory memory(world);
  memory.reserve(100);
  if (world.size() == 1) {
    EXPECT_FALSE(memory.is_open());
    return;
  }
  for (int rank = 0; rank < world.size(); ++rank) EXPECT_TRUE(memory.is_near(rank));
  for (std::int64_t time = 1; time <= 2000; ++time) pass_round(memory, time);
}

TEST_F(NodeMemoryOf, ARankGrowsWhenAnyNeedsMore) {
  NodeMemory memory(world);
  if (world.size() == 1) return;
  std::int64_t time = 0;
  for (const std::size_t bytes : {std::size_t{10}, std::size_t{1} << 20, std::size_t{100}}) {
    memory.reserve(world.is_root() ? bytes : 8);
    memory.take(time);
    memory.post(time);
    pass_round(memory, ++time);
    world.barrier();  // all have read
    if (world.is_root()) std::memset(memory.mine(), 1, bytes);
    world.barrier();
  }
}

TEST_F(NodeMemoryOf, SomeRanksIsSharedBySoMany) {
  for (const int most : {1, 2, 3}) {
    const NodeRanks node(most);
    NodeMemory memory(world);
    memory.reserve(8);
    const int here = world.rank() / most;
    const bool has_neighbours = std::min(most, world.size() - here * most) > 1;
    EXPECT_EQ(memory.is_open(), has_neighbours);
    for (int rank = 0; rank < world.size(); ++rank)
      EXPECT_EQ(memory.is_near(rank), has_neighbours && rank / most == here);
  }
}

TEST_F(NodeMemoryOf, ASettingThatIsNoNumberOfRanksIsRefused) {
  if (world.size() == 1) GTEST_SKIP() << "one rank asks for no memory";
  for (const std::string setting : {"", "two", "2 ranks", "0", "-1", "99999999999"}) {
    const NodeRanks node(setting);
    EXPECT_THROW(NodeMemory{world}, Error) << setting;
  }
}

TEST_F(NodeMemoryOf, ASettingThatOneRankRefusesIsRefusedByAll) {
  if (world.size() == 1) GTEST_SKIP() << "one rank asks for no memory";
  const NodeRanks node(world.is_root() ? "two" : "2");
  EXPECT_THROW(NodeMemory{world}, Error);
}

TEST_F(NodeMemoryOf, ARunLeavesNothingBehind) {
  NodeMemory memory(world);
  memory.reserve(8);
  world.barrier();
  const std::string mine = "repose-" + std::to_string(getpid()) + "-";
  for (const auto& entry : std::filesystem::directory_iterator("/dev/shm")) {
    EXPECT_FALSE(entry.path().filename().string().starts_with(mine)) << entry.path();
  }
}

}  // namespace
}  // namespace repose::test
