// The report that is renewed while runs go on; the Python that makes it is a script of ours.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/error.h"
#include "campaign/live_report.h"
#include "files/shared_file.h"

namespace repose {
namespace {

namespace fs = std::filesystem;

class LiveReportTest : public testing::Test {
 protected:
  LiveReportTest() : folder_(fs::temp_directory_path() / ("repose_report_" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
    setenv("REPOSE_PYTHON", (folder_ / "python").c_str(), 1);
  }
  ~LiveReportTest() override {
    unsetenv("REPOSE_PYTHON");
    fs::remove_all(folder_);
  }

  /// Our Python: these lines of a shell. Its words are -B, the script, --output=FILE, -- and the directory.
  void python(const std::string& lines) const {
    const fs::path path = folder_ / "python";
    std::ofstream(path) << "#!/bin/sh\nfile=${3#--output=}\n" << lines << '\n';
    fs::permissions(path, fs::perms::owner_all);
  }
  std::string report() const { return (folder_ / "report.html").string(); }
  std::string made() const { return fs::exists(report()) ? read_whole_file(report()) : ""; }
  void wait_for(const std::string& text) const {
    for (int k = 0; k < 1000 && made() != text; ++k) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_EQ(made(), text);
  }

  const fs::path folder_;
  const RunLog log_{.progress = nullptr};
};

TEST_F(LiveReportTest, IsThereFromTheStartAndAgainAtTheEnd) {
  python("echo $5 >> $file");
  LiveReport live("runs", report(), log_);
  EXPECT_EQ(made(), "runs\n");
  live.renew();  // too early
  live.finish();
  EXPECT_EQ(made(), "runs\nruns\n");
}

TEST_F(LiveReportTest, IsRenewedWithoutWaitingForIt) {
  python("echo once >> $file");
  LiveReport live("runs", report(), log_, 0.0);
  python("mkfifo $file.gate 2> /dev/null; read word < $file.gate; echo $word >> $file");
  const std::string gate = report() + ".gate";
  for (int k = 0; k < 1000 && !fs::exists(gate); ++k) {
    live.renew();
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  ASSERT_TRUE(fs::exists(gate));
  for (int k = 0; k < 100; ++k) live.renew();  // one at a time
  EXPECT_EQ(made(), "once\n");
  std::ofstream(gate) << "again\n";
  wait_for("once\nagain\n");
}

TEST_F(LiveReportTest, DoesNotWaitForOneThatIsLateBeforeTheLast) {
  python("echo once >> $file");
  LiveReport live("runs", report(), log_, 0.0);
  python("touch $file.begun; exec sleep 600");
  for (int k = 0; k < 1000 && !fs::exists(report() + ".begun"); ++k) {
    live.renew();
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  python("echo last >> $file");
  live.finish();
  EXPECT_EQ(made(), "once\nlast\n");
}

TEST_F(LiveReportTest, FailsBeforeTheRunsOrElseWarns) {
  python("echo 'a trace' >&2; echo 'repose: FILE: cannot be written' >&2; exit 4");
  testing::internal::CaptureStderr();
  try {
    LiveReport live("runs", report(), log_);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::file);
    EXPECT_STREQ(error.what(), "FILE: cannot be written");
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "a trace\n");
  python("echo once >> $file");
  LiveReport live("runs", report(), log_);
  fs::remove(folder_ / "python");
  testing::internal::CaptureStderr();
  live.finish();
  EXPECT_NE(testing::internal::GetCapturedStderr().find("repose: warning: report needs Python"), std::string::npos);
  python("kill -9 $$");
  testing::internal::CaptureStderr();
  live.finish();
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "repose: warning: report: Python ended with code 137\n");
}

}  // namespace
}  // namespace repose
