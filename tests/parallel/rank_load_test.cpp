// What the ranks count of their own load, in a scene whose counts are known.
#include <gtest/gtest.h>

#include "simulation_counts.h"
#include "support/scenes.h"

namespace repose::test {
namespace {

constexpr int grains = 24;
constexpr std::int64_t steps = 50;

/// A row of grains at rest that nearly touch, so that the lists hold each with its neighbours and stay as they are.
Scene row_at_rest() {
  std::vector<Grain> row;
  const double r = 2.2e-4;
  for (int k = 0; k < grains; ++k) row.push_back({{k * (2.0 * r + 5e-7), 0.0, 0.0}, {}, {}, r});
  return {bare_deck({}, 4e-6), row};
}

// The row is cut between the ranks, and at each cut two grains are ghosts and one pair is evaluated twice.
TEST(RankLoad, CountsPairsGhostsAndTraffic) {
  Scene scene = row_at_rest();
  Simulation& s = scene.simulation();
  s.advance(steps);
  const Traffic traffic = s.load().traffic(s.comm());
  const int cuts = s.comm().size() - 1;
  EXPECT_EQ(s.load().steps(), steps);
  EXPECT_EQ(s.comm().sum(s.load().pairs_per_step()), grains - 1 + cuts);
  EXPECT_EQ(s.comm().sum(s.load().ghosts_per_step()), 2 * cuts);
  EXPECT_EQ(s.comm().sum(traffic.messages), 2 * cuts * steps);
  EXPECT_EQ(s.comm().sum(traffic.bytes), 2 * cuts * steps * static_cast<std::int64_t>(sizeof(Motion)));
  EXPECT_EQ(traffic.collectives, cuts > 0 ? steps : 0) << "one reduction per step";
}

TEST(RankLoad, ImbalanceIsThatOfThePairs) {
  Scene scene = row_at_rest();
  Simulation& s = scene.simulation();
  s.advance(steps);
  RankLoad load = s.load();
  EXPECT_EQ(load.imbalance(), 1.0) << "nothing has been compared";
  load.compare(s.comm());
  const double mean = (grains - 1.0 + s.comm().size() - 1.0) / s.comm().size();
  const double busiest = s.comm().max(load.pairs_per_step());
  EXPECT_NEAR(load.imbalance(), busiest / mean, 1e-14);
  // Steps without a pair on any rank count as balanced, and what was compared counts once.
  for (int k = 0; k < steps; ++k) load.count_step(0, 0);
  load.compare(s.comm());
  load.compare(s.comm());
  EXPECT_NEAR(load.imbalance(), 0.5 * (busiest / mean + 1.0), 1e-14);
}

// The processor time of the stages is estimated from every 32nd step: positive where the work was, never more than the
// wall time of the whole, but for the error of that sample.
TEST(RankLoad, ProcessorTimeOfStages) {
  StageClock clock;
  volatile double sink = 0.0;
  for (int step = 0; step < 640; ++step) {
    clock.begin_step();
    clock.enter(Stage::pair_contacts);
    for (int k = 0; k < 20000; ++k) sink = sink + 1.0;
    clock.enter(Stage::agreement);
  }
  const StageClock::Seconds cpu = clock.estimated_cpu_seconds();
  const double work = cpu[static_cast<std::size_t>(Stage::pair_contacts)];
  EXPECT_GT(work, 0.0);
  EXPECT_LT(cpu[static_cast<std::size_t>(Stage::agreement)], work);
  EXPECT_EQ(cpu[static_cast<std::size_t>(Stage::lists)], 0.0);
  EXPECT_EQ(StageClock().estimated_cpu_seconds()[0], 0.0);
}

}  // namespace
}  // namespace repose::test
