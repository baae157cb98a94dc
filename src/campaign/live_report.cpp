#include "campaign/live_report.h"

#include <algorithm>
#include <utility>

#include "base/error.h"

namespace repose {

LiveReport::LiveReport(std::string directory, std::string output, const RunLog& log, double least_pause)
    : directory_(std::move(directory)), output_(std::move(output)), log_(log), least_pause_(least_pause) {
  start();
  end();
}

void LiveReport::renew() {
  constexpr double pauses = 30.0;  // each as long as the last report took: Python takes a core from a run
  try {
    if (maker_ != nullptr && maker_->is_running()) return;
    if (maker_ != nullptr) end();
    if (seconds_since(started_) >= std::max(least_pause_, pauses * took_)) start();
  } catch (const Error& error) {
    log_.warn(error.what());
  }
}

void LiveReport::finish() {
  try {
    start();
    end();
  } catch (const Error& error) {
    log_.warn(error.what());
  }
}

/// One that is still being made is left off: it may have been begun before the last run ended.
void LiveReport::start() {
  maker_.reset();
  started_ = WallClock::now();
  maker_ = start_report(directory_, output_, ChildProcess::Says::nothing);
}

void LiveReport::end() {
  const std::unique_ptr<ChildProcess> maker = std::move(maker_);
  finish_report(*maker);
  took_ = seconds_since(started_);
}

}  // namespace repose
