#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "files/atomic_file.h"
#include "files/directory.h"
#include "output/progress.h"
#include "output/snapshot_series.h"
#include "output/summary.h"
#include "output/time_series.h"
#include "output/trace.h"
#include "output_samples.h"

namespace repose {
namespace {

class TextOutputTest : public ::testing::Test {
 protected:
  /// The message of the FileError that `work` must throw.
  template <class Work>
  std::string failure(Work&& work) {
    try {
      work();
    } catch (const FileError& error) {
      return error.what();
    }
    return "no error";
  }

  Communicator comm_{MPI_COMM_SELF};
  ScratchFolder folder_{comm_, "repose_text_test"};
};

TEST_F(TextOutputTest, AtomicFileReplaces) {
  const std::string path = folder_ / "a.txt";
  write_text_file(path, "first, longer");
  write_text_file(path, "second");
  EXPECT_EQ(file_bytes(path), "second");
  EXPECT_FALSE(std::filesystem::exists(partial_path(path)));
}

TEST_F(TextOutputTest, AtomicFileNamesTheFailure) {
  const std::string missing = folder_ / "missing/a.txt";
  EXPECT_EQ(failure([&] { write_text_file(missing, "x"); }), missing + ": cannot open: No such file or directory");
  std::filesystem::create_directory(folder_ / "folder");
  const std::string folder = folder_ / "folder";
  EXPECT_EQ(failure([&] { write_text_file(folder, "x"); }), folder + ": cannot replace: not a regular file");
  EXPECT_FALSE(std::filesystem::exists(partial_path(folder)));
}

TEST_F(TextOutputTest, AtomicFileNeverReplacesADevice) {
  EXPECT_EQ(failure([] { write_text_file("/dev/full", "x"); }), "/dev/full: cannot replace: not a regular file");
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

TEST_F(TextOutputTest, DirectoryIsCreatedWithParents) {
  create_output_directory(folder_ / "a/b/c");
  create_output_directory(folder_ / "a/b/c");
  EXPECT_TRUE(std::filesystem::is_empty(folder_ / "a/b/c"));
  create_output_directory(folder_ / "a/d/");
  EXPECT_TRUE(std::filesystem::is_directory(folder_ / "a/d"));
}

TEST_F(TextOutputTest, DirectoryFailures) {
  const std::string file = folder_ / "file";
  write_text_file(file, "x");
  EXPECT_EQ(failure([&] { create_output_directory(file); }),
            file + ": cannot create the output folder: a file of this name is in the way");
  EXPECT_EQ(failure([&] { create_output_directory(file + "/below"); }),
            file + "/below: cannot create the output folder: Not a directory");
  EXPECT_NE(failure([] { create_output_directory("/proc/output"); }).find("/proc/output: cannot"), std::string::npos);
  EXPECT_NE(failure([] { create_output_directory("/proc"); }).find("cannot open"), std::string::npos);
}

TEST_F(TextOutputTest, TimeSeriesGrowsReadably) {
  TimeSeries series(folder_ / "series.csv", {"step", "time_s", "energy_j"});
  EXPECT_EQ(file_bytes(folder_ / "series.csv"), "step,time_s,energy_j\n");
  const std::array<TimeSeries::Value, 3> first{std::int64_t{0}, 0.1, 1.0 / 3.0};
  const std::array<TimeSeries::Value, 3> second{std::int64_t{9007199254740993}, -1e-300, -std::nan("")};
  series.append(first);
  EXPECT_EQ(file_bytes(folder_ / "series.csv"), "step,time_s,energy_j\n0,0.1,0.3333333333333333\n");
  series.append(second);
  EXPECT_EQ(file_bytes(folder_ / "series.csv"),
            "step,time_s,energy_j\n0,0.1,0.3333333333333333\n9007199254740993,-1e-300,nan\n");
  EXPECT_THROW(series.append(std::span(first).first(2)), std::logic_error);
}

TEST_F(TextOutputTest, FullDisk) {
  EXPECT_EQ(failure([] { TimeSeries("/dev/full", {"step"}); }), "/dev/full: cannot write: No space left on device");
  EXPECT_EQ(failure([] { Trace("/dev/full"); }), "/dev/full: cannot write: No space left on device");
  const std::string missing = folder_ / "missing/series.csv";
  EXPECT_EQ(failure([&] { TimeSeries(missing, {"step"}); }), missing + ": cannot open: No such file or directory");
}

TEST_F(TextOutputTest, TraceInFullPrecision) {
  Trace trace(folder_ / "trace.csv");
  const double third = 1.0 / 3.0;
  const std::array<TraceRow, 2> rows{{{1, {third, 0.0, -0.0}, {1e-30, 1e30, 2.0}, {4.0, 5.0, 6.0}}, {7, {}, {}, {}}}};
  trace.append(20, rows);
  const std::string text = file_bytes(folder_ / "trace.csv");
  EXPECT_EQ(
      text,
      "step,id,x,y,z,vx,vy,vz,wx,wy,wz\n20,1,0.3333333333333333,0,-0,1e-30,1e+30,2,4,5,6\n20,7,0,0,0,0,0,0,0,0,0\n");
  EXPECT_EQ(std::stod(text.substr(text.find("0.3"))), third);
}

TEST_F(TextOutputTest, SnapshotSeriesIsValidAfterEachAddition) {
  SnapshotSeries series(folder_ / "run.hdf.series");
  series.add("a.hdf", 0.1);
  series.add("b \"quoted\".hdf", 0.25);
  series.add("a.hdf", 0.125);
  const auto json = nlohmann::json::parse(file_bytes(folder_ / "run.hdf.series"));
  EXPECT_EQ(json["file-series-version"], "1.0");
  ASSERT_EQ(json["files"].size(), 2U);
  EXPECT_EQ(json["files"][0]["name"], "a.hdf");
  EXPECT_EQ(json["files"][0]["time"], 0.125);
  EXPECT_EQ(json["files"][1]["name"], "b \"quoted\".hdf");
  const std::string text = file_bytes(folder_ / "run.hdf.series");
  std::filesystem::remove(folder_ / "run.hdf.series");
  series.rewrite();
  EXPECT_EQ(file_bytes(folder_ / "run.hdf.series"), text);
  SnapshotSeries(folder_ / "run.hdf.series").rewrite();  // of none
  EXPECT_FALSE(std::filesystem::exists(folder_ / "run.hdf.series"));
}

Summary sample_summary() {
  Summary summary;
  summary.status = "done";
  summary.ranks = 4;
  summary.time_s = 0.1;
  summary.inserted = 9362;
  summary.exits = {{"z_min", 3, 0.25}, {"chute", 5, 1.0 / 3.0}};
  summary.phases = {{"fill", 50000, "time"}, {"discharge", 220000, "max_time"}};
  summary.figures = {{"retained_mass_kg", 1.0 / 3.0}, {"angle_of_repose_deg", std::nan("")}, {"plugged", false}};
  summary.particle_steps_per_second = std::numeric_limits<double>::infinity();
  summary.state_hash = "not UTF-8: \xff";
  return summary;
}

TEST_F(TextOutputTest, SummaryHasEveryKeyAndNoNan) {
  write_summary(folder_ / "summary.json", sample_summary());
  const std::string text = file_bytes(folder_ / "summary.json");
  EXPECT_EQ(text.find("nan"), std::string::npos);
  EXPECT_EQ(text.find("inf"), std::string::npos);
  const auto json = nlohmann::json::parse(text);
  for (const char* key : {"status", "ranks", "steps", "time_s", "timestep_s", "particles", "state_hash",
                          "retained_mass_kg", "plugged", "phases", "angle_of_repose_deg", "wall_seconds",
                          "particle_steps_per_second", "timing", "lists", "parallel", "memory", "build"}) {
    EXPECT_TRUE(json.contains(key)) << key;
  }
  EXPECT_EQ(json["particles"]["inserted"], 9362);
  EXPECT_EQ(json["particles"]["exits"]["z_min"], 3);
  EXPECT_EQ(json["particles"]["exits"]["chute"], 5);
  EXPECT_EQ(json["particles"]["exit_mass_kg"]["z_min"], 0.25);
  EXPECT_EQ(json["particles"]["exit_mass_kg"]["chute"].get<double>(), 1.0 / 3.0);
  EXPECT_EQ(json["phases"][1]["ended_by"], "max_time");
  EXPECT_EQ(json["retained_mass_kg"].get<double>(), 1.0 / 3.0);
  EXPECT_EQ(json["plugged"], false);
  for (const char* key : {"angle_of_repose_deg", "particle_steps_per_second"}) {
    EXPECT_TRUE(json[key].is_null()) << key;
  }
}

TEST_F(TextOutputTest, ParallelFiguresOfASummary) {
  Summary summary = sample_summary();
  ParallelSummary& p = summary.cost.parallel;
  p.bisections = 3;
  p.imbalance = 1.125;
  p.loop_cpu_seconds = {1.0, 2.0, 3.0};
  p.work_cpu_seconds = {0.5, 0.625, 0.75};
  p.pairs_per_step = {10.0, 11.0, 12.0};
  p.ghosts_per_step = {4.0, 5.0, 6.0};
  p.messages_per_step = {1.0, 1.5, 2.0};
  p.bytes_per_step = {72.0, 108.0, 144.0};
  p.collectives_per_step = 1.25;
  const auto json = nlohmann::json::parse(summary_json(summary))["parallel"];
  EXPECT_EQ(json["bisections"], 3);
  EXPECT_EQ(json["imbalance"], 1.125);
  EXPECT_EQ(json["loop_cpu_s"]["max"], 3.0);
  EXPECT_EQ(json["work_cpu_s"]["mean"], 0.625);
  EXPECT_EQ(json["pairs_per_step"]["min"], 10.0);
  EXPECT_EQ(json["ghosts_per_step"]["mean"], 5.0);
  EXPECT_EQ(json["messages_per_step"]["max"], 2.0);
  EXPECT_EQ(json["bytes_per_step"]["min"], 72.0);
  EXPECT_EQ(json["collectives_per_step"], 1.25);
}

TEST(ProgressTest, Line) {
  ProgressState state{120000, 0.6, 0.4499, "discharge", 9362, 18324, 3.2e-11, 8.1e6, 1.034, 170.0};
  const std::string line = progress_line(state);
  EXPECT_EQ(
      line,
      "step    120000     0.6000 s   44 %  phase discharge       9362 particles     18324 contacts  Ek 3.20e-11 J  "
      "  8.1 M particle-steps/s  imbalance 1.03  at most 3 min left");
  state.step = 7;
  state.contacts = 0;
  state.seconds_left.reset();
  EXPECT_EQ(progress_line(state).find("contacts"), line.find("contacts"));
  EXPECT_TRUE(progress_line(state).ends_with("unknown left"));
}

TEST(ProgressTest, Durations) {
  EXPECT_EQ(duration_text(0.0), "0 s");
  EXPECT_EQ(duration_text(44.2), "45 s");
  EXPECT_EQ(duration_text(119.0), "119 s");
  EXPECT_EQ(duration_text(120.0), "2 min");
  EXPECT_EQ(duration_text(2.0 * 3600.0 + 290.0), "2 h 05 min");
  EXPECT_EQ(duration_text(102.0 * 3600.0), "4 d 06 h");
  EXPECT_EQ(duration_text(std::nan("")), "unknown");
  EXPECT_EQ(duration_text(-1.0), "unknown");
  EXPECT_EQ(duration_text(1e30), "unknown");
}

TEST(ProgressTest, Counts) {
  EXPECT_EQ(short_count(850.0), "850");
  EXPECT_EQ(short_count(8123.0), "8.1 k");
  EXPECT_EQ(short_count(999999.0), "1.0 M");
  EXPECT_EQ(short_count(12.34e6), "12.3 M");
  EXPECT_EQ(short_count(2e9), "2.0 G");
}

TEST(BuildInfoTest, SaysWhereItComesFrom) {
  const BuildInfo build = build_info("avx2");
  for (const auto& [name, text] : build_fields(build)) EXPECT_FALSE(text.empty()) << name;
  EXPECT_TRUE(build.commit == "unknown" || build.commit.size() >= 40) << build.commit;
  EXPECT_NE(build.flags.find("-ffp-contract=off"), std::string::npos) << build.flags;
  EXPECT_EQ(build.flags.find("$<"), std::string::npos) << build.flags;
  EXPECT_EQ(build.hdf5.substr(0, 2), "1.") << build.hdf5;
  const std::string text = version_text("avx2");
  EXPECT_TRUE(text.starts_with("repose " + build.version + "\n")) << text;
  EXPECT_NE(text.find("vector_level avx2\n"), std::string::npos) << text;
}

}  // namespace
}  // namespace repose
