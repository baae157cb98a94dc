#pragma once

#include <functional>
#include <optional>
#include <string>

#include "base/wall_clock.h"

namespace repose {

/// Asked on each rank every few steps with the wall time in s that stopping will take: why the run is to stop now, if
/// it is. The ranks agree on the answers.
using StopAsked = std::function<std::optional<std::string>(double)>;

/// Notes SIGTERM, SIGINT and SIGUSR1 while it lives, instead of being ended by them. A second one, half a second or
/// more after the first, ends the process at once (batch systems like to send the same signal by two ways). One at a
/// time.
class StopRequest {
 public:
  StopRequest();
  ~StopRequest();
  StopRequest(const StopRequest&) = delete;
  StopRequest& operator=(const StopRequest&) = delete;

  /// In s since this object was made.
  void set_time_limit(std::optional<double> seconds) { time_limit_ = seconds; }

  /// "SIGTERM", or "the time limit" when less than `needed` s are left of it.
  std::optional<std::string> reason(double needed) const;

 private:
  WallClock::time_point start_ = WallClock::now();
  std::optional<double> time_limit_;
};

}  // namespace repose
