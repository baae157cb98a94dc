// What the folders of runs say, and what of it gets into the tables and to the estimate.
#include <cmath>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "campaign/observables.h"
#include "campaign/run_folder.h"
#include "run/summary_figures.h"

namespace repose::test {
namespace {

const std::vector<std::string> figures = {"discharged_mass_kg", "angle_of_repose_deg"};

class RunFolder : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder); }
  void TearDown() override { std::filesystem::remove_all(folder); }
  void write(const std::string& name, const std::string& text) { std::ofstream(folder / name) << text; }

  std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("repose_run_folder_test_" + std::to_string(getpid()));
};

const std::string summary = R"({"plugged": PLUGGED, "discharged_mass_kg": 0.02, "angle_of_repose_deg": null,
  "state_hash": "ab", "wall_seconds": 3.5, "ranks": 2, "restarts": 1,
  "phases": [{"name": "settle", "ended_by": "max_time"}, {"name": "discharge", "ended_by": "kinetic_energy"}]})";

std::string summary_with(const std::string& plugged) {
  std::string text = summary;
  return text.replace(text.find("PLUGGED"), 7, plugged);
}

TEST_F(RunFolder, WaitsUntilThereIsASummary) {
  EXPECT_EQ(read_run_folder(folder / "missing", figures).state, RunState::waiting);
  const RunRecord record = read_run_folder(folder, figures);
  EXPECT_EQ(record.state, RunState::waiting);
  EXPECT_EQ(record.figures.size(), 2U);
}

TEST_F(RunFolder, HasBegunWithItsFirstCheckpoint) {
  write("checkpoint_0000000100.hdf.partial", "");
  EXPECT_FALSE(read_run_folder(folder, figures).has_checkpoint);
  write("checkpoint_0000000100.hdf", "");
  const RunRecord record = read_run_folder(folder, figures);
  EXPECT_TRUE(record.has_checkpoint);
  EXPECT_EQ(record.state, RunState::waiting);
}

TEST_F(RunFolder, DoneOrPlugged) {
  write("summary.json", summary_with("false"));
  const RunRecord record = read_run_folder(folder, figures);
  EXPECT_EQ(record.state, RunState::done);
  EXPECT_EQ(record.figures[0], 0.02);
  EXPECT_FALSE(record.figures[1]);
  EXPECT_EQ(record.wall_seconds, 3.5);
  EXPECT_EQ(record.ranks, 2);
  EXPECT_EQ(record.restarts, 1);
  EXPECT_EQ(record.overdue, std::vector<std::string>{"settle"});
  write("summary.json", summary_with("true"));
  EXPECT_EQ(read_run_folder(folder, figures).state, RunState::plugged);
  write("summary.json", summary_with("null"));
  EXPECT_EQ(read_run_folder(folder, figures).state, RunState::done);
}

TEST_F(RunFolder, OnlyBrokenPhysicsStaysFailed) {
  write_failure(folder, ExitCode::file, "disk full");
  EXPECT_EQ(read_run_folder(folder, figures).state, RunState::waiting);
  EXPECT_EQ(read_run_folder(folder, figures).failure, ExitCode::file);
  EXPECT_EQ(read_run_folder(folder, figures).reason, "disk full");
  write_failure(folder, ExitCode::physics, "too deep");
  EXPECT_EQ(read_run_folder(folder, figures).state, RunState::failed);
  EXPECT_EQ(read_run_folder(folder, figures).reason, "too deep");
  remove_failure(folder);
  EXPECT_EQ(read_run_folder(folder, figures).state, RunState::waiting);
}

TEST_F(RunFolder, DamagedFilesAreNamed) {
  for (const std::string& text : {std::string("{"), std::string("[]"), std::string(R"({"discharged_mass_kg": 1})")}) {
    write("summary.json", text);
    EXPECT_THROW(read_run_folder(folder, figures), Error) << text;
  }
  std::filesystem::remove(folder / "summary.json");
  write("failed.json", R"({"code": "three"})");
  EXPECT_THROW(read_run_folder(folder, figures), FileError);
}

RunRecord record_of(RunState state, std::optional<double> mass, std::optional<double> angle) {
  RunRecord record;
  record.state = state;
  record.figures = {mass, angle};
  return record;
}

TEST(Observables, APluggedRunCountsForTheMassAlone) {
  const std::vector<RunRecord> records = {
      record_of(RunState::done, 0.02, 30.0), record_of(RunState::plugged, 0.001, 12.0),
      record_of(RunState::done, 0.03, std::nullopt), record_of(RunState::failed, std::nullopt, std::nullopt)};
  const std::vector<double> mass = values_of_figure(records, figures[0], 0);
  EXPECT_EQ(mass[0], 0.02);
  EXPECT_EQ(mass[1], 0.001);
  EXPECT_EQ(mass[2], 0.03);
  EXPECT_TRUE(std::isnan(mass[3]));
  const std::vector<double> angle = values_of_figure(records, figures[1], 1);
  EXPECT_EQ(angle[0], 30.0);
  for (const std::size_t k : {1U, 2U, 3U}) EXPECT_TRUE(std::isnan(angle[k])) << k;
}

TEST(Observables, APluggedRunDoesNotCountForAMassOfFlowingRunsOnly) {
  const std::vector<RunRecord> records = {record_of(RunState::done, 0.02, 30.0),
                                          record_of(RunState::plugged, 0.001, std::nullopt)};
  CalibrationDeck deck;
  ObservableDeck& o = deck.observables.emplace_back();
  o.figure = figures[0];
  EXPECT_EQ(observable_data(deck, records)[0].values[1], 0.001);
  o.flowing_only = true;
  const std::vector<double> mass = observable_data(deck, records)[0].values;
  EXPECT_EQ(mass[0], 0.02);
  EXPECT_TRUE(std::isnan(mass[1]));
  EXPECT_TRUE(counts(records[0], o));
  EXPECT_FALSE(counts(records[1], o));
}

TEST(Observables, TheStandardErrorIsThatOfTheMean) {
  CalibrationDeck deck;
  ObservableDeck& o = deck.observables.emplace_back();
  o.figure = figures[0];
  o.laboratory = 0.02;
  o.deviation = 0.004;
  o.repeats = 16;
  o.deviation_is_known = false;
  o.scale = ObservableScale::square_root;
  const std::vector<ObservableData> data = observable_data(deck, {});
  EXPECT_DOUBLE_EQ(data[0].laboratory.standard_error(), 0.001);
  EXPECT_EQ(data[0].laboratory.freedom, 15.0);
  EXPECT_EQ(data[0].transform, Transform::square_root);
  o.deviation_is_known = true;
  EXPECT_TRUE(std::isinf(observable_data(deck, {})[0].laboratory.freedom));
}

TEST(RequireFigure, NamesTheSectionOrTheNearest) {
  Deck deck;
  deck.discharge.enabled = true;
  require_figure(deck, "discharged_mass_kg");
  const auto message = [&](const std::string& figure) -> std::string {
    try {
      require_figure(deck, figure);
    } catch (const DeckError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(message("angle_of_repose_deg").find("[measurement.angle_of_repose]"), std::string::npos);
  EXPECT_NE(message("scattering.area1.count").find("\"scattering.area_1.count\""), std::string::npos);
}

}  // namespace
}  // namespace repose::test
