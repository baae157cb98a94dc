#pragma once

#include <cstdlib>
#include <iostream>
#include <string>
#include <string_view>

#include "base/error.h"

namespace repose::fuzz {

/// What one fuzz target does with one input: true when it is accepted, false when it is refused as it should be, in one
/// line. Everything else is a finding: another exception, a sanitizer's report, too much memory or time, or a promise
/// that does not hold. Each target defines it, in a file of its own.
bool accepts(std::string_view input);

/// Ends the process, which is a finding, when a promise does not hold.
inline void expect(bool holds, std::string_view promise) {
  if (holds) return;
  std::cerr << "does not hold: " << promise << std::endl;
  std::abort();
}

/// Whether `work` is done; false when it refuses its input (exit code 2 or 4) in one line.
template <class Work>
bool is_done(const Work& work) {
  try {
    work();
    return true;
  } catch (const Error& error) {
    const std::string message = error.what();
    expect(error.code() != ExitCode::physics, "an input is refused as such: " + message);
    expect(message.find_first_of("\n\r") == std::string::npos, "a message is one line: " + message);
    return false;
  }
}

}  // namespace repose::fuzz
