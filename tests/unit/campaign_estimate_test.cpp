// What is said of an estimate, and of runs from which there can be none.
#include <optional>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "campaign/estimate_report.h"
#include "campaign/level_report.h"
#include "campaign/level_runs.h"
#include "deck_error.h"

namespace repose::test {
namespace {

std::string parameter(const std::string& name) {
  return "[[parameter]]\nname = \"" + name + "\"\nkey = \"pair.0." + name + "\"\nvalues = [0, 0.25, 0.5, 0.75, 1]\n";
}

std::string observable(const std::string& figure, double laboratory, double deviation) {
  return fmt::format("[[observable]]\nfigure = \"{}\"\nlaboratory = {}\ndeviation = {}\n", figure, laboratory,
                     deviation);
}

const std::string levels =
    "[[level]]\nname = \"soft\"\nset = [\"a.b=1\"]\n[[level]]\nname = \"hard\"\nset = [\"a.b=2\"]\n";

CalibrationDeck read(const std::string& text) {
  return read_calibration_deck("base = \"a.toml\"\nseeds = 1\n" + text, "study.toml");
}

/// Runs at all points of a deck, free of noise.
struct Done {
  template <class Figures>
  Done(const CalibrationDeck& deck, Figures figures)
      : runs(level_runs(deck, {}, at_every_level(deck, points_of(deck)))) {
    for (const StudyRun& run : runs) {
      RunRecord& record = records.emplace_back();
      record.state = RunState::done;
      record.figures = figures(run);
    }
  }
  std::vector<StudyRun> runs;
  std::vector<RunRecord> records;
};

using Figures = std::vector<std::optional<double>>;

Figures both(const StudyRun& run) { return {run.values[0], run.values[1]}; }

std::string text_of(const CalibrationDeck& deck, const Done& done) {
  return report_of({deck, done.records, {}}, done.runs).text;
}

// The laboratory lies beyond the range, but not by more than its errors.
TEST(EstimateReport, HasTheRegionOfANearestPointThatIsAcceptable) {
  const CalibrationDeck deck =
      read(parameter("x") + parameter("y") + observable("f", 1.02, 0.05) + observable("g", 0.5, 0.05));
  const std::string text = text_of(deck, Done(deck, both));
  EXPECT_NE(text.find("no crossing"), std::string::npos) << text;
  EXPECT_NE(text.find("nearest point\n  x                        1, 95 % region 0."), std::string::npos) << text;
  EXPECT_NE(text.find(" to above 1\n"), std::string::npos) << text;
  EXPECT_NE(text.find("  y                        0.5, 95 % region 0."), std::string::npos) << text;
}

// A crossing at the one end, and at the other a bend that comes within the errors only.
TEST(EstimateReport, HasThePartsOfTheRegionWithoutACrossing) {
  const CalibrationDeck deck =
      read("[[parameter]]\nname = \"x\"\nkey = \"a.x\"\nmin = 0\nmax = 1\npoints = 21\n" + observable("f", 0.5, 0.05));
  const auto figures = [](const StudyRun& run) -> Figures {
    const double x = run.values[0];
    return {x < 0.5 ? 0.45 - 8.0 * (x - 0.2) * (x - 0.2) : 0.45 - 8.0 * 0.09 + 2.0 * (x - 0.5)};
  };
  const std::string text = text_of(deck, Done(deck, figures));
  EXPECT_NE(text.find("one crossing of the laboratory's contour lines, but the confidence region has 2 separate parts"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("part of the region without such a point\n  x                        95 % region 0.1"),
            std::string::npos)
      << text;
}

TEST(EstimateReport, SaysWhyThereIsNone) {
  const CalibrationDeck deck = read(parameter("x") + observable("f", 0.5, 0.05));
  Done done(deck, [](const StudyRun&) -> Figures { return {std::nullopt}; });
  for (RunRecord& record : done.records) {
    record.state = RunState::failed;
    record.reason = "a grain is lost";
  }
  const std::string message = deck_error([&] { text_of(deck, done); });
  EXPECT_NE(
      message.find("observable \"f\": has a value at 0 points; a surface needs 4 or more; 5 runs: 0 done, 0 plugged, "
                   "5 failed, 0 to come; runs/x=0,seed=1: a grain is lost"),
      std::string::npos)
      << message;
}

TEST(CalibrationDeck, NoneIsACountButHasNoLogarithm) {
  const std::string count = parameter("x") + observable("scattering.area_3.count", 0, 1) + "scale = ";
  EXPECT_EQ(read(count + "\"square_root\"\n").observables[0].laboratory, 0.0);
  EXPECT_NE(deck_error([&] { read(count + "\"logarithm\"\n"); }).find("\"laboratory\" must be above 0"),
            std::string::npos);
}

TEST(EstimateReport, CountsWhatHasBeenRunOfEachLevel) {
  const CalibrationDeck deck = read(parameter("x") + observable("f", 0.5, 0.05) + levels);
  Done done(deck, [](const StudyRun& run) -> Figures { return {run.values[0]}; });
  done.records.back() = {};  // waits
  const std::string text = text_of(deck, done);
  EXPECT_NE(text.find("level soft                 5 points, 5 runs, "), std::string::npos) << text;
  EXPECT_NE(text.find("level hard                 4 points, 4 runs, "), std::string::npos) << text;
}

// Of the second observable only the first seeds have a value.
TEST(EstimateReport, SaysWhoseScatterAnObservableOfALevelHas) {
  const CalibrationDeck deck =
      read(parameter("x") + observable("f", 0.5, 0.05) + observable("g", 0.5, 0.05) + levels + "seeds = 2\n");
  const std::string text = text_of(deck, Done(deck, [](const StudyRun& run) -> Figures {
                                     if (run.seed > 1) return {run.values[0], std::nullopt};
                                     return {run.values[0], run.values[0]};
                                   }));
  const std::size_t f = text.find("f                          hard = ");
  const std::size_t g = text.find("g                          hard = ");
  ASSERT_NE(f, std::string::npos) << text;
  ASSERT_NE(g, std::string::npos) << text;
  const std::string taken = "% of it explained; 0 second seeds: scatters as soft\n";
  EXPECT_EQ(text.substr(f, g - f).find("second seeds"), std::string::npos) << text;
  EXPECT_NE(text.find(taken, g), std::string::npos) << text;
}

// All five points of the level are done, but two were plugged.
TEST(KnownLevels, CountPointsWithAValueOfEachObservable) {
  const CalibrationDeck deck =
      read("[[parameter]]\nname = \"x\"\nkey = \"a.x\"\nvalues = [0, 0.25, 0.5, 0.75, 1]\n" +
           observable("discharged_mass_kg", 0.5, 0.05) + observable("angle_of_repose_deg", 20, 1) + levels);
  Done done(deck, [](const StudyRun& run) -> Figures { return {run.values[0], 20.0 * run.values[0]}; });
  EXPECT_EQ(known_levels(deck, done.runs, done.records).left_out, "");
  for (std::size_t i = 0; i < done.runs.size(); ++i) {
    if (done.runs[i].level == 1 && done.runs[i].values[0] < 0.3) done.records[i].state = RunState::plugged;
  }
  const KnownLevels known = known_levels(deck, done.runs, done.records);
  EXPECT_EQ(known.deck.levels.size(), 1U);
  EXPECT_EQ(known.left_out,
            "level hard is left out: observable \"angle_of_repose_deg\": has a value at 3 points; a surface "
            "needs 4 or more\n");
  EXPECT_NE(deck_error([&] { text_of(deck, done); }).find("level hard: observable \"angle_of_repose_deg\""),
            std::string::npos);
}

// Two tests: that the one has run at all points says nothing of the other.
TEST(KnownLevels, CountPointsOfEachExperiment) {
  std::string tests;
  for (const std::string name : {"a", "b"}) {
    tests += "[[experiment]]\nname = \"" + name + "\"\n[[experiment.observable]]\nfigure = \"f\"\nlaboratory = 0.5\n" +
             "deviation = 0.05\n";
  }
  const CalibrationDeck deck = read(parameter("x") + levels + tests);
  Done done(deck, [](const StudyRun& run) -> Figures {
    return run.experiment == 0 ? Figures{run.values[0], std::nullopt} : Figures{std::nullopt, run.values[0]};
  });
  EXPECT_EQ(known_levels(deck, done.runs, done.records).left_out, "");
  for (std::size_t i = 0; i < done.runs.size(); ++i) {
    if (done.runs[i].level == 1 && done.runs[i].experiment == 1 && done.runs[i].values[0] > 0.1) {
      done.records[i].state = RunState::waiting;
    }
  }
  const KnownLevels known = known_levels(deck, done.runs, done.records);
  EXPECT_EQ(known.deck.levels.size(), 1U);
  EXPECT_NE(known.left_out.find("observable \"b.f\": has a value at 1 points"), std::string::npos) << known.left_out;
}

}  // namespace
}  // namespace repose::test
