#include "output/run_log.h"

#include <fmt/core.h>

namespace repose {

void RunLog::say(const std::string& line) const {
  if (progress == nullptr) return;
  fmt::print(progress, "{}\n", line);
  std::fflush(progress);
}

void RunLog::warn(const std::string& text) const {
  fmt::print(warnings, "repose: warning: {}\n", text);
  std::fflush(warnings);
}

}  // namespace repose
