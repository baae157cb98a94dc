// How many steps inner skins are made to last.
#include <gtest/gtest.h>

#include "neighbours/inner_horizon.h"

namespace repose::test {
namespace {

/// After `lists` outer lists that were used up after so many steps each.
std::int64_t after(int lists, std::int64_t steps) {
  InnerHorizon horizon;
  for (int k = 0; k < lists; ++k) horizon.outer_lasted(steps);
  return horizon.steps();
}

TEST(InnerHorizon, LongestWhereOuterListsLast) {
  EXPECT_EQ(after(0, 0), 32);
  EXPECT_EQ(after(9, 128), 32);
  EXPECT_EQ(after(9, 100000), 32);
}

TEST(InnerHorizon, ShorterWhereTheyDoNot) {
  EXPECT_EQ(after(1, 127), 16);
  EXPECT_EQ(after(9, 64), 16);
  EXPECT_EQ(after(9, 63), 8);
  EXPECT_EQ(after(9, 0), 8);
}

TEST(InnerHorizon, LongerAgainAsSoonAsTheyLast) {
  InnerHorizon horizon;
  for (int k = 0; k < 3; ++k) horizon.outer_lasted(1);
  horizon.outer_lasted(64);
  EXPECT_EQ(horizon.steps(), 8);
  horizon.outer_lasted(65);
  EXPECT_EQ(horizon.steps(), 16);
  horizon.outer_lasted(129);
  EXPECT_EQ(horizon.steps(), 32);
}

}  // namespace
}  // namespace repose::test
