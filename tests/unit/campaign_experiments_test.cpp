// Several tests in one calibration: what the file may say, and which runs it comes to.
#include <filesystem>

#include <gtest/gtest.h>
#include <unistd.h>

#include "campaign/level_runs.h"
#include "campaign/observables.h"
#include "deck/calibration_deck.h"
#include "deck_error.h"

namespace repose::test {
namespace {

const std::string parameter = R"([[parameter]]
name = "sliding"
key = "pair.0.sliding_friction"
values = [0.1, 0.5]
)";
const std::string two_tests = R"([[experiment]]
name = "funnel"
base = "funnel.toml"
[[experiment.observable]]
figure = "discharged_mass_kg"
laboratory = 1
deviation = 0.1
[[experiment]]
name = "drum"
base = "drum.toml"
set = ["run.check_every=10"]
seeds = 3
[[experiment.observable]]
figure = "discharged_mass_kg"
laboratory = 2
deviation = 0.1
[[experiment.observable]]
name = "angle"
curve = "angle.csv"
series = "surface_angle.csv"
x = "time_s"
y = "surface_angle_deg"
)";
const std::string levels = "[[level]]\nname = \"soft\"\nset = [\"a.b=1\"]\n[[level]]\nname = \"hard\"\n";
const std::string own_level = R"([[experiment.level]]
name = "soft"
base = "small_drum.toml"
set = ["c.d=2"]
seeds = 5
)";

CalibrationDeck read(const std::string& text) { return read_calibration_deck("seeds = 2\n" + text, "study.toml"); }
std::string message(const std::string& text) {
  return deck_error([&] { read(text); });
}

TEST(Experiments, TheirObservablesHaveTheirNames) {
  const CalibrationDeck deck = read(parameter + two_tests);
  ASSERT_EQ(deck.observables.size(), 3U);
  EXPECT_EQ(deck.observables[0].figure, "funnel.discharged_mass_kg");
  EXPECT_EQ(deck.observables[1].figure, "drum.discharged_mass_kg");
  EXPECT_EQ(deck.observables[1].key, "discharged_mass_kg");
  EXPECT_EQ(deck.observables[1].measured(), "discharged_mass_kg");
  EXPECT_EQ(deck.observables[1].experiment, 1U);
  EXPECT_EQ(deck.observables[2].figure, "drum.angle");
}

TEST(Experiments, EachHasItsBaseAndSeeds) {
  const CalibrationDeck deck = read(parameter + levels + two_tests + own_level);
  const StudyDeck soft_drum = study_of_level(deck, 0, 1);
  EXPECT_EQ(soft_drum.base, "small_drum.toml");
  EXPECT_EQ(soft_drum.set, (std::vector<std::string>{"run.check_every=10", "a.b=1", "c.d=2"}));
  EXPECT_EQ(soft_drum.seeds, 5);
  const StudyDeck hard_drum = study_of_level(deck, 1, 1);
  EXPECT_EQ(hard_drum.base, "drum.toml");
  EXPECT_EQ(hard_drum.seeds, 3);
  EXPECT_EQ(study_of_level(deck, 0, 0).base, "funnel.toml");
  EXPECT_EQ(study_of_level(deck, 0, 0).seeds, 2);
}

TEST(Experiments, AllRunAtEachPoint) {
  const CalibrationDeck deck = read(parameter + two_tests);
  const std::vector<StudyRun> runs = level_runs(deck, {}, at_every_level(deck, points_of(deck)));
  ASSERT_EQ(runs.size(), 10U);  // two points, two and three seeds
  EXPECT_EQ(runs[0].name, "funnel/sliding=0.1,seed=1");
  EXPECT_EQ(runs[4].name, "drum/sliding=0.1,seed=1");
  EXPECT_EQ(runs[4].experiment, 1U);
  EXPECT_EQ(runs[4].overrides[0], "run.check_every=10");
  const auto folder = std::filesystem::temp_directory_path() / ("repose_experiments_" + std::to_string(getpid()));
  for (const StudyRun& run : runs) std::filesystem::create_directories(folder / run.name);
  const std::vector<StudyRun> found = level_runs_in(folder, deck);
  ASSERT_EQ(found.size(), runs.size());
  for (std::size_t i = 0; i < runs.size(); ++i) {
    EXPECT_EQ(found[i].name, runs[i].name);
    EXPECT_EQ(found[i].experiment, runs[i].experiment);
  }
  std::filesystem::remove_all(folder);
}

TEST(Experiments, SaysWhatIsWrong) {
  const auto expect = [](const std::string& text, const std::string& part) {
    EXPECT_NE(message(text).find(part), std::string::npos) << message(text);
  };
  const auto with = [](std::string text, const std::string& old, const std::string& now) {
    return text.replace(text.find(old), old.size(), now);
  };
  expect(parameter, "lacks \"base\"");
  expect("base = \"a.toml\"\n" + parameter, "lacks [[observable]]");
  expect(parameter + two_tests + "[[observable]]\nfigure = \"a\"\nlaboratory = 1\ndeviation = 1\n",
         "each observable is an [[experiment.observable]]");
  expect(parameter + with(two_tests, "\"drum\"", "\"funnel\""), "\"funnel\" names another experiment, too");
  expect(parameter + with(two_tests, "\"drum\"", "\"../drum\""), "names a folder");
  expect(parameter + with(two_tests, "base = \"drum.toml\"\n", ""), "lacks \"base\"");
  expect(parameter + two_tests + own_level, "\"soft\" is no [[level]] of the file");
  expect(parameter + levels + two_tests + own_level + own_level, "\"soft\" stands here twice");
  expect(parameter + with(levels, "set = [\"a.b=1\"]", "base = \"b.toml\"") + two_tests,
         "stands in [[experiment.level]]");
  expect(parameter + with(two_tests, "series = \"surface_angle.csv\"\n", ""), "series");
  expect(parameter + with(two_tests, "series = \"surface", "series = \"../surface"), "in the folder of a run");
  expect(parameter + with(two_tests, "y = \"surface_angle_deg\"\n", "y = \"surface_angle_deg\"\nlaboratory = 3\n"),
         "laboratory");
  expect(parameter + with(two_tests, "deviation = 0.1\n", "deviation = 0.1\ncomponents = 2\n"), "components");
  EXPECT_EQ(message(parameter + two_tests), "no error");
}

// A plugged funnel says nothing of the drum, and the runs of the one are none of the other's.
TEST(Experiments, RunsCountForTheirOwn) {
  const CalibrationDeck deck = read(parameter + two_tests);
  std::vector<StudyRun> runs(2);
  runs[1].experiment = 1;
  const RunLevels of = levels_of(deck, runs);
  EXPECT_EQ(of.experiment_of_run, (std::vector<std::size_t>{0, 1}));
  EXPECT_TRUE(of.of_run.empty());
}

}  // namespace
}  // namespace repose::test
