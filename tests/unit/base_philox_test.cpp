#include <cmath>

#include <gtest/gtest.h>

#include "base/philox.h"

namespace repose {
namespace {

using Words = std::array<std::uint32_t, 4>;

// Known answers from the authors' distribution, Random123 1.14 (kat_vectors).
TEST(Philox, GivesTheKnownAnswers) {
  constexpr std::uint32_t ones = 0xffffffff;
  EXPECT_EQ(philox4x32({0, 0, 0, 0}, {0, 0}), (Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(philox4x32({ones, ones, ones, ones}, {ones, ones}),
            (Words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(philox4x32({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

// The leading 53 bits of the first two words of the first known answer.
TEST(Uniform, HasAllTheDigitsOfADouble) {
  EXPECT_EQ(uniform(0, 0, RandomStream::insertion_jitter, 0), 0xcc4fd1abc2d38p-53);
}

TEST(Uniform, DependsOnEachArgument) {
  constexpr auto stream = RandomStream::insertion_jitter;
  constexpr auto other_stream = static_cast<RandomStream>(1);
  constexpr std::uint64_t high = std::uint64_t{1} << 40;
  const double reference = uniform(1, 2, stream, 3);
  EXPECT_EQ(uniform(1, 2, stream, 3), reference);
  EXPECT_NE(uniform(2, 2, stream, 3), reference);
  EXPECT_NE(uniform(1 + high, 2, stream, 3), reference);
  EXPECT_NE(uniform(1, 3, stream, 3), reference);
  EXPECT_NE(uniform(1, 2 + high, stream, 3), reference);
  EXPECT_NE(uniform(1, 2, other_stream, 3), reference);
  EXPECT_NE(uniform(1, 2, stream, 4), reference);
}

// The mean of n numbers has a standard error of 1/sqrt(12 n), the share in a tenth one of sqrt(0.09/n); bounds: 5
// sigma.
TEST(Uniform, FillsTheUnitInterval) {
  constexpr int n = 100000;
  double sum = 0.0;
  std::array<int, 10> tenths{};
  for (std::uint64_t id = 0; id < n; ++id) {
    const double x = uniform(42, id, RandomStream::insertion_jitter, 0);
    ASSERT_GE(x, 0.0);
    ASSERT_LT(x, 1.0);
    sum += x;
    ++tenths[static_cast<std::size_t>(10.0 * x)];
  }
  EXPECT_NEAR(sum / n, 0.5, 5.0 / std::sqrt(12.0 * n));
  for (const int count : tenths) EXPECT_NEAR(count / static_cast<double>(n), 0.1, 5.0 * std::sqrt(0.09 / n));
}

}  // namespace
}  // namespace repose
