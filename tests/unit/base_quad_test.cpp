// The four-wide helpers against the plain operations.
#include <cstdint>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "base/quad.h"
#include "base/vector_level.h"

namespace repose::test {
namespace {

double through_quads(VectorLevel level, std::int64_t value) {
  Quad result = {};
  const QuadInt values = {value, 0, -value, value};
  at_level(level, [&]() REPOSE_INLINE { result = to_double(values); });
  EXPECT_EQ(result[1], 0.0);
  EXPECT_EQ(result[3], result[0]);
  return result[0];
}

TEST(Quad, IntegersBecomeTheNearestDoubles) {
  std::vector<std::int64_t> values = {0, 1, -1, 0xffffffff, 0x100000000, -0x100000000};
  for (int bit = 0; bit < 63; ++bit) {
    const std::int64_t power = std::int64_t{1} << bit;
    for (const std::int64_t near : {power - 1, power, power + 1, power + power / 2 + 1}) {
      values.push_back(near);
      values.push_back(-near);
    }
  }
  values.push_back(std::numeric_limits<std::int64_t>::max());
  std::uint64_t state = 1;
  for (int k = 0; k < 10000; ++k) {  // Knuth's generator, all magnitudes
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    values.push_back(static_cast<std::int64_t>(state) >> (k % 60));
  }
  for (const VectorLevel level : {VectorLevel::sse2, best_vector_level()}) {
    for (const std::int64_t value : values) EXPECT_EQ(through_quads(level, value), static_cast<double>(value)) << value;
  }
}

TEST(Quad, TransposesRowsIntoColumns) {
  Quad a = {0, 1, 2, 3}, b = {10, 11, 12, 13}, c = {20, 21, 22, 23}, d = {30, 31, 32, 33};
  transpose(a, b, c, d);
  const Quad* columns[] = {&a, &b, &c, &d};
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) EXPECT_EQ((*columns[column])[row], 10 * row + column);
  }
}

}  // namespace
}  // namespace repose::test
