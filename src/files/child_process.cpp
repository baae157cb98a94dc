#include "files/child_process.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

#include <fcntl.h>
#include <fmt/core.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/error.h"

namespace repose {

ChildProcess::ChildProcess(std::vector<std::string> words, Says says) : said_(memfd_create("said", MFD_CLOEXEC)) {
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, said_, STDERR_FILENO);
  if (says == Says::nothing) posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  const int failure =
      said_ < 0 ? errno : posix_spawnp(&child_, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failure == 0) return;
  if (said_ >= 0) close(said_);
  throw FileError(fmt::format("{}: cannot be started: {}", words[0], std::strerror(failure)));
}

ChildProcess::~ChildProcess() {
  if (child_ != 0) kill(child_, SIGTERM);
  wait(0);
  close(said_);
}

bool ChildProcess::is_running() {
  wait(WNOHANG);
  return child_ != 0;
}

ChildProcess::Outcome ChildProcess::outcome() {
  wait(0);
  Outcome outcome{{}, WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_)};
  std::array<char, 4096> buffer;
  for (off_t place = 0;;) {
    const ssize_t count = pread(said_, buffer.data(), buffer.size(), place);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return outcome;
    outcome.said.append(buffer.data(), static_cast<std::size_t>(count));
    place += count;
  }
}

void ChildProcess::wait(int options) {
  while (child_ != 0) {
    const pid_t ended = waitpid(child_, &status_, options);
    if (ended == 0) return;
    if (ended < 0 && errno == EINTR) continue;
    child_ = 0;
  }
}

}  // namespace repose
