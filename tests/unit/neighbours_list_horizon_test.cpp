// How long outer lists are made to last.
#include <limits>

#include <gtest/gtest.h>

#include "neighbours/list_horizon.h"

namespace repose::test {
namespace {

constexpr double share = 0.3;
constexpr double dt = 5e-6;

/// Grains of 0.2 mm radius, of which one in `one_in` moves by 0.01 radii in a step of dt.
Particles grains(std::size_t count, std::size_t one_in) {
  Particles p;
  for (std::size_t i = 0; i < count; ++i) {
    ParticleRecord record = {};
    record.radius = 2e-4;
    record.position = {1e-3 * static_cast<double>(i), 0.0, 0.0};
    if (i % one_in == 0) record.velocity = {0.0, 0.0, -0.4};
    p.record.push_back(record);
  }
  p.owned = count;
  return p;
}

/// After lists of which each particle had `listed` pairs.
std::int64_t chosen(const Particles& p, std::size_t listed) {
  ListHorizon horizon;
  horizon.choose(ListHorizon::count(p, share, dt, 0));
  horizon.choose(ListHorizon::count(p, share, dt, listed * p.owned));
  return horizon.steps();
}

TEST(ListHorizon, CountsParticlesAndTheCubesOfTheirReaches) {
  Particles p = grains(10, 10);
  park(p.record[9], 9);
  const ListHorizon::Counts counts = ListHorizon::count(p, share, dt, 7);
  EXPECT_EQ(counts[0], 9);
  EXPECT_EQ(counts[1], 7);
  EXPECT_EQ(counts[2], 8 * 2 + 91);  // 1.3^3 = 2.197 for those at rest, (1.3 + 3.2)^3 = 91.1, whole parts
  EXPECT_EQ(counts[4], 8 * 2 + 9);   // (1.3 + 0.8)^3 = 9.26
}

TEST(ListHorizon, LongestAtRestOrWhereFewAreFast) {
  EXPECT_EQ(chosen(grains(1000, 1000), 7), 320);
  EXPECT_EQ(chosen(grains(1000, 100), 8), 320);
}

TEST(ListHorizon, ShorterWhereAllAreFast) {
  EXPECT_LT(chosen(grains(1000, 1), 60), 320);
  EXPECT_LE(chosen(grains(1000, 1), 600), 80);
}

TEST(ListHorizon, LongestWhereTheFastAreFarApart) { EXPECT_EQ(chosen(grains(1000, 1), 0), 320); }

TEST(ListHorizon, NoParticlesAndNoNumbersAreNoTrouble) {
  EXPECT_EQ(chosen(Particles{}, 0), 320);
  Particles p = grains(10, 1);
  p.record[3].velocity.x = std::numeric_limits<double>::quiet_NaN();
  p.record[4].velocity.x = 1e300;
  for (const std::int64_t count : ListHorizon::count(p, share, dt, 0)) EXPECT_GE(count, 0);
}

}  // namespace
}  // namespace repose::test
