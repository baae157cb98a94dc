#pragma once

#include <memory>
#include <string>

#include "base/wall_clock.h"
#include "campaign/report_program.h"
#include "output/run_log.h"

namespace repose {

/// The report of a directory, which is renewed while its runs go on. For rank 0. Python makes it beside us and replaces
/// it when it is whole; what runs and decisions are does not depend on it.
class LiveReport {
 public:
  /// Makes it as it is before any run. Error when that cannot be done, so that nobody waits for it in vain. Reports are
  /// `least_pause` s apart or more.
  LiveReport(std::string directory, std::string output, const RunLog& log, double least_pause = 120.0);

  /// Starts a new one when the last is old enough; waits for nothing. What fails now is a warning.
  void renew();
  /// The last one, of all that is there now.
  void finish();

 private:
  void start();
  void end();

  std::string directory_;
  std::string output_;
  const RunLog& log_;
  double least_pause_;
  std::unique_ptr<ChildProcess> maker_;  ///< while it works
  WallClock::time_point started_;
  double took_ = 0.0;  ///< s, the last one
};

}  // namespace repose
