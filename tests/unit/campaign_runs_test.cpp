// Which runs a study has, what they are called, who does them and in which order.
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "campaign/expected_cost.h"
#include "campaign/rank_groups.h"
#include "campaign/run_list.h"
#include "campaign/search.h"
#include "deck/calibration_deck.h"

namespace repose::test {
namespace {

ParameterDeck parameter(const std::string& name, const std::string& key, double min, double max) {
  ParameterDeck p;
  p.name = name;
  p.key = key;
  p.min = min;
  p.max = max;
  return p;
}

StudyDeck study() {
  StudyDeck s;
  s.seeds = 2;
  s.first_seed = 5;
  s.set = {"time.step=1e-6"};
  s.parameters = {parameter("sliding", "pair.0.sliding_friction", 0.1, 0.9),
                  parameter("e", "pair.0.restitution", 0.2, 0.8)};
  return s;
}

TEST(RunList, AllSeedsAtEachPoint) {
  const std::vector<StudyRun> runs = runs_at(study(), {{0.1, 0.2}, {0.9, 0.8}});
  ASSERT_EQ(runs.size(), 4U);
  EXPECT_EQ(runs[1].name, "sliding=0.1,e=0.2,seed=6");
  EXPECT_EQ(runs[2].name, "sliding=0.9,e=0.8,seed=5");
  EXPECT_EQ(runs[2].overrides, (std::vector<std::string>{"time.step=1e-6", "pair.0.sliding_friction=0.9",
                                                         "pair.0.restitution=0.8", "run.seed=5"}));
}

TEST(RunList, APointAgainGetsTheNextSeeds) {
  const std::vector<StudyRun> runs = runs_at(study(), {{0.1, 0.2}, {0.3, 0.2}, {0.1, 0.2}});
  ASSERT_EQ(runs.size(), 6U);
  EXPECT_EQ(runs[4].name, "sliding=0.1,e=0.2,seed=7");
  EXPECT_EQ(runs[5].seed, 8);
}

TEST(RunList, FoldersTellTheirRuns) {
  const auto folder = std::filesystem::temp_directory_path() / ("repose_run_list_test_" + std::to_string(getpid()));
  std::filesystem::remove_all(folder);
  for (const StudyRun& run : runs_at(study(), {{0.1, 1e-7}, {1.0 / 3.0, 0.8}})) {
    std::filesystem::create_directories(folder / run.name);
  }
  for (const char* other : {"sliding=0.1,seed=1", "sliding=0.1,e=x,seed=1", "notes", "sliding=0.1,e=0.2,seed=1.5",
                            "sliding=0.10,e=0.2,seed=1", "sliding=0.1,e=0.2,seed=1,more=2"}) {
    std::filesystem::create_directories(folder / other);
  }
  const std::vector<StudyRun> runs = runs_in(folder, study());
  ASSERT_EQ(runs.size(), 4U);
  EXPECT_EQ(runs[0].values, (std::vector<double>{0.1, 1e-7}));
  EXPECT_EQ(runs[0].seed, 5);
  EXPECT_EQ(runs[1].seed, 6);
  EXPECT_EQ(runs[2].values[0], 1.0 / 3.0);
  std::filesystem::remove_all(folder);
}

using Order = std::vector<std::size_t>;

TEST(RankGroups, RunsThatWantFewRanksComeFirst) {
  StudyDeck wide = study();
  wide.ranks_per_run = 4;
  std::vector<StudyRun> runs = runs_at(study(), {{0.1, 0.2}});
  for (const StudyRun& run : runs_at(wide, {{0.5, 0.2}})) runs.push_back(run);
  EXPECT_EQ(by_ranks(Order{3, 1, 2, 0}, runs), (std::vector<Order>{{1, 0}, {3, 2}}));
  EXPECT_TRUE(by_ranks(Order{}, runs).empty());
}

TEST(RankGroups, AsManyAsThereIsWorkFor) {
  EXPECT_EQ(group_count(8, 1, 100), 8);
  EXPECT_EQ(group_count(8, 3, 100), 2);
  EXPECT_EQ(group_count(2, 16, 100), 1);
  EXPECT_EQ(group_count(8, 1, 3), 3);
  EXPECT_EQ(group_count(8, 1, 0), 1);
}

TEST(RankGroups, SuccessiveRanksEvenly) {
  std::vector<int> sizes(3);
  int before = 0;
  for (int rank = 0; rank < 8; ++rank) {
    const int group = group_of(rank, 8, 3);
    EXPECT_GE(group, before);
    before = group;
    ++sizes.at(static_cast<std::size_t>(group));
  }
  for (const int size : sizes) EXPECT_TRUE(size == 2 || size == 3);
}

TEST(ExpectedCost, ByWorkUntilMoreIsKnown) {
  const std::vector<StudyRun> runs = runs_at(study(), {{0.1, 0.2}, {0.5, 0.2}, {0.9, 0.2}});
  const std::vector<RunRecord> records(6);
  EXPECT_EQ(begun_then_longest(runs, records, study().parameters, [](const StudyRun&) { return 1.0; }),
            (Order{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(
      begun_then_longest(runs, records, study().parameters, [](const StudyRun& run) { return 10.0 * run.values[0]; }),
      (Order{4, 5, 2, 3, 0, 1}));
}

TEST(ExpectedCost, AtTheSpeedOfTheNearestCompleteRun) {
  const std::vector<StudyRun> runs = runs_at(study(), {{0.1, 0.2}, {0.5, 0.2}, {0.9, 0.2}});
  std::vector<RunRecord> records(6);
  records[0].state = RunState::done;
  records[0].wall_seconds = 10.0;
  records[0].ranks = 1;
  records[4].state = RunState::plugged;
  records[4].wall_seconds = 5.0;
  records[4].ranks = 4;
  EXPECT_EQ(begun_then_longest(runs, records, study().parameters, [](const StudyRun&) { return 7.0; }),
            (Order{5, 1, 2, 3}));
  records[4].wall_seconds = 1.0;
  EXPECT_EQ(begun_then_longest(runs, records, study().parameters, [](const StudyRun&) { return 7.0; }),
            (Order{1, 2, 3, 5}));
}

TEST(ExpectedCost, ARunThatFailedCountsAsLongAsItWasExpectedToTake) {
  CalibrationDeck deck;
  deck.study = study();
  deck.adaptive.core_speed = 1e6;
  const std::vector<StudyRun> runs = runs_at(deck.study, {{0.1, 0.2}, {0.5, 0.2}});
  std::vector<RunRecord> records(4);
  for (std::size_t i : {0U, 1U}) {
    records[i].state = RunState::done;
    records[i].particle_steps = 3.6e9;
  }
  EXPECT_DOUBLE_EQ(core_hours(deck, runs, records), 2.0);
  records[2].state = RunState::failed;
  EXPECT_DOUBLE_EQ(core_hours(deck, runs, records), 3.0);
}

TEST(ExpectedCost, WhatHasBegunIsEndedBeforeMoreBegins) {
  const std::vector<StudyRun> runs = runs_at(study(), {{0.1, 0.2}, {0.5, 0.2}, {0.9, 0.2}});
  std::vector<RunRecord> records(6);
  records[0].has_checkpoint = records[3].has_checkpoint = true;
  EXPECT_EQ(
      begun_then_longest(runs, records, study().parameters, [](const StudyRun& run) { return 10.0 * run.values[0]; }),
      (Order{3, 0, 4, 5, 2, 1}));
}

CalibrationDeck grid() {
  CalibrationDeck deck;
  deck.study = study();
  deck.study.parameters[0].points = 3;
  deck.study.parameters[1].values = {0.2, 0.8};
  return deck;
}

TEST(PointsOf, TheLastParameterIsTheFastest) {
  const std::vector<std::vector<double>> expected = {{0.1, 0.2}, {0.1, 0.8}, {0.5, 0.2},
                                                     {0.5, 0.8}, {0.9, 0.2}, {0.9, 0.8}};
  EXPECT_EQ(points_of(grid()), expected);
}

TEST(PointsOf, AListOrNoneInASearch) {
  CalibrationDeck deck = grid();
  deck.points = {{{0.3, 0.3}, ""}};
  EXPECT_EQ(points_of(deck), (std::vector<std::vector<double>>{{0.3, 0.3}}));
  deck.adaptive.enabled = true;
  EXPECT_TRUE(points_of(deck).empty());
}

/// Of the first design of a search, those of a level.
std::vector<std::vector<double>> first_points(const CalibrationDeck& deck, std::size_t level) {
  std::vector<std::vector<double>> points;
  for (const LevelPoint& point : first_design(deck)) {
    if (point.level == level) points.push_back(point.values);
  }
  return points;
}

TEST(FirstDesign, HasListedPointsBesideItsOwnAtTheirLevels) {
  CalibrationDeck deck;
  deck.study = study();
  deck.levels.resize(2);
  deck.levels[0].name = "small";
  deck.levels[1].name = "large";
  deck.levels[1].start = 4;
  deck.adaptive.enabled = true;
  deck.adaptive.start = 6;
  const auto small = first_points(deck, 0);
  const auto large = first_points(deck, 1);
  ASSERT_EQ(small.size(), 6U);
  ASSERT_EQ(large.size(), 4U);
  deck.points = {{{0.3, 0.3}, "large"}, {{0.123456789, 0.5}, ""}, {large[2], "large"}};
  auto with_listed = small;
  with_listed.push_back({0.123457, 0.5});
  EXPECT_EQ(first_points(deck, 0), with_listed);
  with_listed = large;
  with_listed.insert(with_listed.end(), {{0.3, 0.3}, {0.123457, 0.5}, large[2]});
  EXPECT_EQ(first_points(deck, 1), with_listed);
  const std::vector<StudyRun> runs = runs_at(deck.study, first_points(deck, 1));  // the last again: further seeds
  EXPECT_EQ(runs[runs.size() - 2].seed, 7);
}

}  // namespace
}  // namespace repose::test
