#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/error.h"
#include "comm/agreement.h"
#include "commands/command.h"

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

/// What a program says on its standard error, and its exit code. Its standard output goes where ours does.
struct Outcome {
  std::string said;
  int code = 0;
};

Outcome call(std::vector<std::string> words) {
  int ends[2];
  if (pipe(ends) != 0) throw FileError("report: cannot make a pipe");
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
  posix_spawn_file_actions_addclose(&actions, ends[0]);
  posix_spawn_file_actions_addclose(&actions, ends[1]);
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t child = 0;
  const int failure = posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  Outcome outcome;
  char buffer[4096];
  for (ssize_t count = 0; failure == 0 && (count = read(ends[0], buffer, sizeof buffer)) != 0;) {
    if (count > 0) outcome.said.append(buffer, static_cast<std::size_t>(count));
    if (count < 0 && errno != EINTR) break;
  }
  close(ends[0]);
  if (failure != 0) {
    throw FileError(fmt::format(
        "report needs Python, but {} cannot be started; install python3, or name one in REPOSE_PYTHON", words[0]));
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return outcome;
}

/// Passes on what Python has said: its last line becomes the error when it has failed.
void pass_on(Outcome outcome) {
  std::string& said = outcome.said;
  while (said.ends_with('\n')) said.pop_back();
  if (outcome.code == 0) {
    if (!said.empty()) fmt::print(stderr, "{}\n", said);
    return;
  }
  const std::size_t begin = said.rfind('\n') + 1;  // 0 when there is one line
  if (begin > 0) fmt::print(stderr, "{}", said.substr(0, begin));
  std::string line = said.substr(begin);
  if (line.starts_with("repose: ")) line.erase(0, 8);
  if (line.empty()) line = fmt::format("report: Python ended with code {}", outcome.code);
  throw Error(static_cast<ExitCode>(outcome.code), line);
}

class Report : public Command {
 public:
  void declare(Options& options) override {
    options.argument("DIR", directory_, "directory of a run, calibration, validation or sensitivity study");
    options.option("--output", output_, "FILE", "the report; DIR/report.html if not given");
  }

  void carry_out(Process& process) override {
    agree_after_root(process.ranks(), [&] {
      const char* python = std::getenv("REPOSE_PYTHON");
      std::vector<std::string> words = {python != nullptr ? python : "python3", "-B", report_script().string()};
      if (!output_.empty()) words.push_back("--output=" + output_);
      words.insert(words.end(), {"--", directory_});
      std::fflush(stdout);
      pass_on(call(std::move(words)));
    });
  }

 private:
  std::string directory_;
  std::string output_;
};

}  // namespace

std::unique_ptr<Command> report_command() { return std::make_unique<Report>(); }

}  // namespace repose
