#pragma once

#include <cstdio>
#include <string>

namespace repose {

/// Where a run says how it goes on and what it wonders about. Rank 0 alone writes to it. Does not own the files.
struct RunLog {
  std::FILE* progress = stdout;  ///< null: nothing is said
  std::FILE* warnings = stderr;

  /// A line as it is.
  void say(const std::string& line) const;
  /// "repose: warning: " and the text.
  void warn(const std::string& text) const;
};

}  // namespace repose
