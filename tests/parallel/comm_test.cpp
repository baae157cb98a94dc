// The communicator's typed calls and the order-independent sum.
#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

#include "comm/buffer.h"
#include "comm/communicator.h"
#include "comm/order_independent_sum.h"
#include "comm/shared_counters.h"
#include "support/draw.h"

namespace repose::test {
namespace {

class Comm : public ::testing::Test {
 protected:
  const Communicator world{MPI_COMM_WORLD};
  const Communicator self{MPI_COMM_SELF};
  const int rank = world.rank();
  const int size = world.size();
};

TEST_F(Comm, Reductions) {
  EXPECT_EQ(world.sum(std::int64_t{rank + 1}), std::int64_t{size} * (size + 1) / 2);
  EXPECT_EQ(world.max(static_cast<double>(rank)), size - 1.0);
  EXPECT_EQ(world.min(rank), 0);
  EXPECT_EQ(world.exclusive_sum(rank + 1), std::int64_t{rank} * (rank + 1) / 2);
  std::vector<std::int64_t> values = {1, rank, -rank};
  world.sum_elements(std::span(values));
  const std::int64_t ranks = std::int64_t{size} * (size - 1) / 2;
  EXPECT_EQ(values, (std::vector<std::int64_t>{size, ranks, -ranks}));
  std::vector<double> greatest = {static_cast<double>(rank), static_cast<double>(-rank)};
  world.max_elements(std::span(greatest));
  EXPECT_EQ(greatest, (std::vector<double>{size - 1.0, 0.0}));
}

TEST_F(Comm, GatherKeepsTheRankOrder) {
  std::vector<int> mine(static_cast<std::size_t>(rank % 3), rank);  // none on rank 0, 3, ...
  std::vector<int> expected;
  for (int r = 0; r < size; ++r) expected.insert(expected.end(), static_cast<std::size_t>(r % 3), r);
  EXPECT_EQ(world.gather(mine), world.is_root() ? expected : std::vector<int>{});
  const std::vector<int> all = world.all_gather(10 * rank);
  EXPECT_EQ(all.size(), static_cast<std::size_t>(size));
  EXPECT_EQ(all.back(), 10 * (size - 1));
}

TEST_F(Comm, BroadcastsStringsOfAnyLength) {
  for (int root = 0; root < size; ++root) {
    for (const std::size_t length : {std::size_t{0}, std::size_t{1}, std::size_t{100000}}) {
      std::string text = rank == root ? std::string(length, static_cast<char>('a' + root)) : "something else";
      const std::size_t piece = length == 100000 ? 999 : Communicator::longest_piece;
      world.broadcast(text, root, piece);
      EXPECT_EQ(text, std::string(length, static_cast<char>('a' + root)));
    }
  }
  std::string with_zero = rank == 0 ? std::string("a\0b", 3) : std::string();
  world.broadcast(with_zero);
  EXPECT_EQ(with_zero, std::string("a\0b", 3));
}

/// What rank `from` sends to rank `to`: of a length that differs for all, and nothing for some.
std::vector<char> letter(int from, int to) {
  const int length = (from * 31 + to * 17) % 5 == 0 ? 0 : 1000 * from + 7 * to + 1;
  std::vector<char> text(static_cast<std::size_t>(length));
  for (std::size_t i = 0; i < text.size(); ++i) text[i] = static_cast<char>(static_cast<int>(i) + from * 8 + to);
  return text;
}

TEST_F(Comm, ExchangeDeliversEveryLetter) {
  for (int round = 0; round < 3; ++round) {
    std::vector<std::vector<char>> send;
    for (int to = 0; to < size; ++to) send.push_back(letter(rank, to + round));
    const std::vector<std::vector<char>> received =
        world.exchange(send, round == 0 ? Communicator::longest_piece : 100);
    EXPECT_EQ(received.size(), static_cast<std::size_t>(size));
    for (int from = 0; from < size; ++from) {
      EXPECT_EQ(received[static_cast<std::size_t>(from)], letter(from, rank + round));
    }
  }
}

TEST_F(Comm, ErrorsBecomeExceptions) {
  int value = 0;
  EXPECT_THROW(check_mpi(MPI_Bcast(&value, 1, MPI_INT, size, self.handle()), "MPI_Bcast"), std::runtime_error);
}

TEST(PackBuffer, GivesBackWhatWasPut) {
  std::vector<char> bytes;
  PackBuffer pack(bytes);
  pack.put(std::int32_t{-7});
  pack.put(2.5);
  const std::vector<double> many = {1.0, 2.0, 3.0};
  pack.put_all(std::span<const double>(many));
  pack.put_all(std::span<const double>());
  UnpackBuffer unpack(bytes);
  EXPECT_EQ(unpack.get<std::int32_t>(), -7);
  EXPECT_EQ(unpack.get<double>(), 2.5);
  EXPECT_EQ(unpack.get_vector<double>(3), many);
  EXPECT_TRUE(unpack.get_vector<double>(0).empty());
  EXPECT_TRUE(unpack.at_end());
}

/// Values of both signs over thirty orders of magnitude.
std::vector<double> wide_values(std::size_t count) {
  Draw draw(71);
  std::vector<double> values(count);
  for (double& v : values) v = std::ldexp(draw(-1.0, 1.0), static_cast<int>(draw(-80.0, 20.0)));
  return values;
}

std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

TEST_F(Comm, SumHasTheSameBitsForAnyDistribution) {
  const std::vector<double> values = wide_values(5000);
  const double alone = order_independent_sum(self, values);
  const std::vector<double> backwards(values.rbegin(), values.rend());
  EXPECT_EQ(bits(order_independent_sum(self, backwards)), bits(alone));

  const auto ranks = static_cast<std::size_t>(size);
  const auto here = static_cast<std::size_t>(rank);
  std::vector<double> in_turn;
  std::vector<double> scattered;
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (k % ranks == here) in_turn.push_back(values[k]);
    if ((k * k / 7) % ranks == here) scattered.push_back(values[(k * 1237) % 5000]);  // 1237 is coprime to 5000
  }
  const std::vector<double> all_on_the_last = rank == size - 1 ? values : std::vector<double>{};
  EXPECT_EQ(bits(order_independent_sum(world, in_turn)), bits(alone));
  EXPECT_EQ(bits(order_independent_sum(world, scattered)), bits(alone));
  EXPECT_EQ(bits(order_independent_sum(world, all_on_the_last)), bits(alone));
}

TEST_F(Comm, SumIsAccurate) {
  const std::vector<double> values = wide_values(5000);
  long double exact = 0.0L;
  double greatest = 0.0;
  for (const double v : values) {
    exact += v;
    greatest = std::fmax(greatest, std::fabs(v));
  }
  // Each value is rounded by at most half a unit of 2^-61 x 2 x 5000 x the greatest; the total once to a double.
  const double bound = 5000.0 * 0x1p-61 * 5000.0 * greatest + 0x1p-53 * std::fabs(static_cast<double>(exact));
  EXPECT_NEAR(order_independent_sum(self, values), static_cast<double>(exact), bound);
}

TEST_F(Comm, SumIsExactWhereItCanBe) {
  const double share = 1.0 + 0x1p-20;
  EXPECT_EQ(order_independent_sum(world, std::vector<double>(100, share)), 100.0 * size * share);
  EXPECT_EQ(order_independent_sum(world, std::vector<double>{1e10, 1e-3, -1e10, -1e-3}), 0.0);
  EXPECT_EQ(order_independent_sum(world, std::vector<double>{}), 0.0);
  EXPECT_EQ(order_independent_sum(world, std::vector<double>{0.0, -0.0}), 0.0);
  const std::vector<double> one = world.is_root() ? std::vector<double>{-1.25e-13} : std::vector<double>{};
  EXPECT_EQ(order_independent_sum(world, one), -1.25e-13);
  const std::vector<double> tiny = {5e-324, 5e-324};
  EXPECT_EQ(order_independent_sum(self, tiny), 1e-323);
  const std::vector<double> large = {1e300, -1e300, 1e285};
  EXPECT_NEAR(order_independent_sum(self, large), 1e285, 1e300 * 0x1p-59);
}

TEST_F(Comm, CountersAreDrawnFromWhileRankZeroIsBusy) {
  constexpr int draws = 50;
  SharedCounters counters(world, 2);
  std::vector<int> drawn;
  for (int i = 0; i < draws; ++i) {
    drawn.push_back(static_cast<int>(counters.add(1, 1)));
    counters.add(0, 10);
    if (world.is_root()) counters.answer();
  }
  for (PatientBarrier barrier(world); !barrier.passed();) {
    if (world.is_root()) counters.answer();
  }
  std::vector<int> all = world.gather(drawn);
  std::sort(all.begin(), all.end());
  std::vector<int> expected(world.is_root() ? static_cast<std::size_t>(draws * size) : 0);
  std::iota(expected.begin(), expected.end(), 0);
  EXPECT_EQ(all, expected);
  if (world.is_root()) {
    EXPECT_EQ(counters.read(0), 10 * draws * size);
  }
}

TEST_F(Comm, RecentValuesOfCountersArriveWithoutWaiting) {
  SharedCounters counters(world, 1);
  if (!world.is_root()) {
    EXPECT_EQ(counters.recent(0), 0);  // nobody answers yet
  }
  counters.add(0, world.is_root() ? 7 : 0);  // the other ranks wait here until rank 0 answers below
  for (PatientBarrier barrier(world); !barrier.passed();) {
    if (world.is_root()) counters.answer();
  }
  if (!world.is_root()) {
    while (counters.recent(0) != 7) std::this_thread::yield();
  }
  for (PatientBarrier barrier(world); !barrier.passed();) {
    if (world.is_root()) counters.answer();
  }
  EXPECT_EQ(counters.recent(0), 7);
}  // what the last call of recent() has asked is answered here

}  // namespace
}  // namespace repose::test
