// Curves of laboratories and runs: their files, and the observables that they become.
#include <cmath>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "campaign/curve_csv.h"
#include "campaign/curve_observables.h"
#include "campaign/observables.h"
#include "deck_error.h"

namespace repose::test {
namespace {

ObservableDeck drain() {
  ObservableDeck o;
  o.figure = o.name = "drain";
  o.curve = "drain.csv";
  o.series = "series.csv";
  o.x = "time_s";
  o.y = "discharged_mass_kg";
  return o;
}

TEST(CurveCsv, TakesCommentsAndBlanks) {
  const LaboratoryCurve curve =
      parse_curve_csv("# a drain\nx, y, deviation\n0.5,1e-3,1e-4\n\n1.5, 2e-3,2e-4\n", "d.csv");
  EXPECT_EQ(curve.x, (std::vector<double>{0.5, 1.5}));
  EXPECT_EQ(curve.y, (std::vector<double>{1e-3, 2e-3}));
  EXPECT_EQ(curve.deviation, (std::vector<double>{1e-4, 2e-4}));
}

TEST(CurveCsv, SaysWhereItIsWrong) {
  const auto message = [](const std::string& text) { return deck_error([&] { parse_curve_csv(text, "drain.csv"); }); };
  EXPECT_EQ(message("time,mass,deviation\n0,1,1\n"),
            "drain.csv:1: the header line reads \"time,mass,deviation\"; it must read x,y,deviation");
  EXPECT_EQ(message("x,y,deviation\n0,1,1\n2,1,1\n1,2,1\n"),
            "drain.csv:4: x = 1 is not above the 2 before; x must rise");
  EXPECT_EQ(message("x,y,deviation\n0,1,1\n0,1,1\n"), "drain.csv:3: x = 0 is not above the 0 before; x must rise");
  EXPECT_EQ(message("x,y,deviation\n0,1,0\n1,1,1\n"),
            "drain.csv:2: deviation = 0 must be above 0; leave out places that are known exactly");
  EXPECT_EQ(message("x,y,deviation\n0,1\n"), "drain.csv:2: 2 fields instead of 3");
  EXPECT_EQ(message("x,y,deviation\n0,one,1\n"), "drain.csv:2: y = \"one\" is not a number; write one such as 4.4e-4");
  EXPECT_EQ(message("x,y,deviation\n0,1,1\n"), "drain.csv:2: a curve takes two lines or more below the header");
  EXPECT_EQ(message(""), "drain.csv:1: the header line must read x,y,deviation");
}

const std::string series =
    "step,time_s,phase,discharged_mass_kg\n0,0,0,0\n100,1,0,0\n200,2,1,1\n300,3,1,3\n400,4,1,4\n";

TEST(RunCurve, IsTakenByNames) {
  const RunCurve curve = parse_run_curve(series, "series.csv", drain(), nullptr);
  EXPECT_EQ(curve.x, (std::vector<double>{0, 1, 2, 3, 4}));
  EXPECT_EQ(curve.y, (std::vector<double>{0, 0, 1, 3, 4}));
  ObservableDeck other = drain();
  other.y = "discharged_mas_kg";
  EXPECT_EQ(deck_error([&] { parse_run_curve(series, "series.csv", other, nullptr); }),
            "series.csv:1: the run's table has no column \"discharged_mas_kg\"; did you mean \"discharged_mass_kg\"?");
  other = drain();
  other.x = "discharged_mass_kg";
  EXPECT_EQ(deck_error([&] { parse_run_curve(series, "series.csv", other, nullptr); }),
            "series.csv:3: observable \"drain\": discharged_mass_kg does not rise here; compare over a column that "
            "does, or within a phase");
}

TEST(RunCurve, RowsWithoutAValueAreLeftOut) {
  const std::string text = "step,time_s,discharged_mass_kg\n0,0,nan\n100,1,2\n200,2,nan\n300,3,4\n400,4,nan\n";
  const RunCurve curve = parse_run_curve(text, "walls.csv", drain(), nullptr);
  EXPECT_EQ(curve.x, (std::vector<double>{1, 3}));
  EXPECT_EQ(curve.y, (std::vector<double>{2, 4}));
  EXPECT_EQ(
      deck_error([&] { parse_run_curve("step,time_s,discharged_mass_kg\n0,nan,1\n", "a.csv", drain(), nullptr); }),
      "a.csv:2: time_s = nan is not finite; write a number such as 4.4e-4");
}

TEST(RunCurve, WithinAPhaseItBeginsAtZero) {
  const StepWindow window = {150, 350};
  const RunCurve curve = parse_run_curve(series, "series.csv", drain(), &window);
  EXPECT_EQ(curve.x, (std::vector<double>{0, 0.5, 1.5, 2}));
  EXPECT_EQ(curve.y, (std::vector<double>{0.5, 1, 3, 3.5}));
}

TEST(RunCurve, OfATableThatBeginsWithinThePhaseCountsFromThePhase) {
  const StepWindow window = {50, 350};
  const RunCurve curve = parse_run_curve("step,time_s,discharged_mass_kg\n100,1,5\n200,2,6\n300,3,8\n400,4,9\n",
                                         "shear.csv", drain(), &window);
  EXPECT_EQ(curve.x, (std::vector<double>{0.5, 1.5, 2.5, 3}));
  EXPECT_EQ(curve.y, (std::vector<double>{5, 6, 8, 8.5}));
  const RunCurve single = parse_run_curve("step,time_s,discharged_mass_kg\n100,1,5\n", "shear.csv", drain(), &window);
  EXPECT_EQ(single.x, std::vector<double>{0});
}

TEST(RunCurve, IsLinearBetweenTheRowsAndNowhereElse) {
  ObservableDeck o = drain();
  o.laboratory_curve = {{0.5, 2.5, 4.0}, {}, {}};
  const RunCurve curve = parse_run_curve(series, "series.csv", o, nullptr);
  EXPECT_EQ(at_places(curve, "series.csv", o), (std::vector<double>{0, 2, 4}));
  o.laboratory_curve.x = {0.5, 4.5};
  EXPECT_EQ(deck_error([&] { at_places(curve, "series.csv", o); }),
            "observable \"drain\": drain.csv has x from 0.5 to 4.5, but time_s of series.csv reaches from 0 to 4; "
            "shorten the curve or let the runs go on longer");
  o.laboratory_curve.x = {-0.5, 3.0};
  EXPECT_NE(deck_error([&] { at_places(curve, "series.csv", o); }), "no error");
}

/// A directory with runs whose mass rises linearly over time, by `slope` in kg/s.
class Projected : public testing::Test {
 protected:
  Projected() {
    deck.study.parameters.resize(1);
    ObservableDeck figure;
    figure.figure = figure.key = "angle_of_repose_deg";
    deck.observables = {figure, drain()};
    deck.observables[1].laboratory_curve = {{0.5, 1.5, 2.5}, {1.0, 3.0, 5.0}, {0.1, 0.1, 0.1}};
    deck.observables[1].repeats = 4;
  }
  ~Projected() override { std::filesystem::remove_all(directory); }

  void add_run(double slope, RunState state) {
    StudyRun& run = runs.emplace_back();
    run.values = {slope};
    run.name = "slope=" + std::to_string(runs.size());
    RunRecord& record = records.emplace_back();
    record.state = state;
    record.figures = {30.0 + slope};
    const auto folder = directory / "runs" / run.name;
    std::filesystem::create_directories(folder);
    if (state == RunState::failed) return;
    std::ofstream file(folder / "series.csv");
    file << "step,time_s,discharged_mass_kg\n";
    for (int k = 0; k <= 6; ++k) file << k << ',' << 0.5 * k << ',' << slope * 0.5 * k << '\n';
    std::ofstream(folder / "summary.json") << R"({"phases": [{"name": "settle", "steps": 2},
      {"name": "discharge", "steps": 4}]})";
  }
  Projection projection() const { return project_curves(deck, directory, runs, records); }

  std::filesystem::path directory =
      std::filesystem::temp_directory_path() / ("repose_curves_test_" + std::to_string(getpid()));
  CalibrationDeck deck;
  std::vector<StudyRun> runs;
  std::vector<RunRecord> records;
};

TEST_F(Projected, EachComponentIsAnObservable) {
  for (const double slope : {1.0, 1.5, 2.0, 2.5}) add_run(slope, RunState::done);
  const Projection p = projection();
  ASSERT_EQ(p.deck.observables.size(), 2U);
  const ObservableDeck& o = p.deck.observables[1];
  EXPECT_EQ(o.figure, "drain.1");
  EXPECT_EQ(o.deviation, 1.0);
  EXPECT_EQ(o.repeats, 4);
  EXPECT_EQ(p.records[3].figures[0], 32.5);
  EXPECT_NEAR(*p.records[2].figures[1], o.laboratory, 1e-9);  // slope 2 is that of the laboratory
  EXPECT_GT(*p.records[3].figures[1], o.laboratory);
  EXPECT_NE(curves_text(p.curves).find("3 points on 1 component, which leave out"), std::string::npos);
}

TEST_F(Projected, WhatHasFailedHasNoCurve) {
  for (const double slope : {1.0, 1.5, 2.0}) add_run(slope, RunState::done);
  add_run(0.5, RunState::failed);
  add_run(0.1, RunState::plugged);
  const Projection p = projection();
  EXPECT_FALSE(p.records[3].figures[1]);
  EXPECT_TRUE(p.records[4].figures[1]);  // of a mass
  deck.observables[1].x = "step";
  deck.observables[1].y = "time_s";
  EXPECT_EQ(deck_error([&] { projection(); }),
            "observable \"drain\": the curves of the runs do not differ from point to point");
  add_run(0.7, RunState::waiting);
  EXPECT_FALSE(counts(records[4], "time_s"));
}

TEST_F(Projected, FromThePhase) {
  for (const double slope : {1.0, 1.5, 2.0}) add_run(slope, RunState::done);
  deck.observables[1].phase = "discharge";
  deck.observables[1].laboratory_curve = {{0.5, 1.0, 2.0}, {3.0, 4.0, 6.0}, {0.1, 0.1, 0.1}};
  const Projection p = projection();
  EXPECT_NEAR(*p.records[2].figures[1], p.deck.observables[1].laboratory, 1e-9);
  deck.observables[1].phase = "drain";
  EXPECT_NE(deck_error([&] { projection(); }).find("has no phase \"drain\", but settle, discharge"), std::string::npos);
}

TEST_F(Projected, TheDiscrepancyIsThatOfTheScore) {
  for (const double slope : {1.0, 1.5, 2.0}) add_run(slope, RunState::done);
  deck.observables[1].discrepancy = 0.2;  // twice the deviation at each x
  EXPECT_NEAR(projection().deck.observables[1].model_deviation(), 2.0, 1e-9);
  deck.observables[1].discrepancy = 0.0;
  deck.observables[1].discrepancy_share = 0.05;
  const double share = projection().deck.observables[1].model_deviation();
  EXPECT_GT(share, 0.5);
  deck.observables[1].discrepancy_share = 0.1;
  EXPECT_NEAR(projection().deck.observables[1].model_deviation(), 2.0 * share, 1e-9);
}

}  // namespace
}  // namespace repose::test
