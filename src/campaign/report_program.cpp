#include "campaign/report_program.h"

#include <cstdlib>
#include <filesystem>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "base/error.h"

namespace repose {
namespace {

namespace fs = std::filesystem;

/// The script that makes reports, in the Python package beside the program: of an installation, or of the source that
/// it was built in.
fs::path report_script() {
  std::error_code unknown;
  const fs::path program = fs::read_symlink("/proc/self/exe", unknown);
  for (fs::path folder = program.parent_path(); folder.has_relative_path(); folder = folder.parent_path()) {
    for (const char* place : {"share/repose/python", "tools/python"}) {
      std::error_code absent;
      fs::path script = folder / place / "repose_report.py";
      if (fs::is_regular_file(script, absent)) return script;
    }
  }
  throw FileError(
      fmt::format("{}: the Python package is not beside it (share/repose/python/repose_report.py); install it with "
                  "cmake --install",
                  program.string()));
}

}  // namespace

std::unique_ptr<ChildProcess> start_report(const std::string& directory, const std::string& output,
                                           ChildProcess::Says says) {
  const char* named = std::getenv("REPOSE_PYTHON");
  const std::string python = named != nullptr ? named : "python3";
  std::vector<std::string> words = {python, "-B", report_script().string()};
  if (!output.empty()) words.push_back("--output=" + output);
  words.insert(words.end(), {"--", directory});
  try {
    return std::make_unique<ChildProcess>(std::move(words), says);
  } catch (const FileError&) {
    throw FileError(fmt::format(
        "report needs Python, but {} cannot be started; install python3, or name one in REPOSE_PYTHON", python));
  }
}

void finish_report(ChildProcess& python) {
  auto [said, code] = python.outcome();
  while (said.ends_with('\n')) said.pop_back();
  if (code == 0) {
    if (!said.empty()) fmt::print(stderr, "{}\n", said);
    return;
  }
  const std::size_t begin = said.rfind('\n') + 1;  // 0 when there is one line
  if (begin > 0) fmt::print(stderr, "{}", said.substr(0, begin));
  std::string line = said.substr(begin);
  if (line.starts_with("repose: ")) line.erase(0, 8);
  if (line.empty()) line = fmt::format("report: Python ended with code {}", code);
  throw Error(static_cast<ExitCode>(code), line);
}

}  // namespace repose
