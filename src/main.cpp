#include <csignal>
#include <cstdio>
#include <exception>

#include <fmt/core.h>

#include "base/error.h"
#include "comm/abort_job.h"
#include "commands/command_line.h"

namespace {

/// What is agreed among the ranks: all of them get here.
int end_with(const repose::Error& error, const repose::Process& process) {
  if (process.ranks().is_root()) fmt::print(stderr, "repose: {}\n", error.what());
  return static_cast<int>(error.code());
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a limit on the size of files: an error of the write, with its message
  repose::Process process(&argc, &argv);
  repose::CommandLine line;
  try {
    line = repose::parse_command_line(argc, argv);
  } catch (const repose::Error& error) {
    process.begin(repose::Process::Need::alone);
    return end_with(error, process);
  }
  process.begin(line.need);
  try {
    line.command->carry_out(process);
    return 0;
  } catch (const repose::Error& error) {
    return end_with(error, process);
  } catch (const std::exception& error) {  // on this rank alone, perhaps: the others may wait for it for ever
    repose::abort_job(process.ranks(), error.what());
  }
}
