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

TEST(Octet, TransposesRowsIntoColumns) {
  Octet rows[8];
  for (int row = 0; row < 8; ++row) {
    for (int column = 0; column < 8; ++column) rows[row][column] = 10 * row + column;
  }
  transpose(rows);
  for (int column = 0; column < 8; ++column) {
    for (int row = 0; row < 8; ++row) EXPECT_EQ(rows[column][row], 10 * row + column);
  }
}

/// Records of four doubles become columns, whatever the number of lanes.
TEST(Octet, LoadsRowsAsColumns) {
  alignas(32) double records[8][8];
  const QuadInMemory* row[8];
  for (int k = 0; k < 8; ++k) {
    for (int j = 0; j < 8; ++j) records[k][j] = 10 * k + j;
    row[k] = reinterpret_cast<const QuadInMemory*>(records[k]);
  }
  Octet a, b, c, d;
  load_rows(row, 1, a, b, c, d);
  for (int k = 0; k < 8; ++k) {
    EXPECT_EQ(a[k], 10 * k + 4);
    EXPECT_EQ(b[k], 10 * k + 5);
    EXPECT_EQ(c[k], 10 * k + 6);
    EXPECT_EQ(d[k], 10 * k + 7);
  }
}

TEST(Octet, CountsAndBits) {
  const Octet values = {1.0, -2.0, 3.0, -4.0, 5.0, 6.0, -7.0, 8.0};
  EXPECT_EQ(count(values > Octet{}), 5);
  EXPECT_EQ(magnitude(values)[6], 7.0);
  EXPECT_EQ(any_bits(OctetBits{1, 0, 2, 0, 0, 16, 0, 128}), 147U);
  EXPECT_EQ(lane_numbers<Octet>()[7], 7);
}

}  // namespace
}  // namespace repose::test
