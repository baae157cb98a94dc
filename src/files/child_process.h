#pragma once

#include <string>
#include <vector>

#include <sys/types.h>

namespace repose {

/// Another program, which works while we go on.
class ChildProcess {
 public:
  enum class Says { where_we_do, nothing };  ///< its standard output
  /// What it has said on its standard error, and its exit code; of a signal, 128 and its number.
  struct Outcome {
    std::string said;
    int code = 0;
  };

  /// Starts the program words[0], found as a shell finds it, with the other words. FileError when it cannot be started.
  ChildProcess(std::vector<std::string> words, Says says);
  /// Ends it if it still runs.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Waits for nothing.
  bool is_running();
  /// Waits for its end.
  Outcome outcome();

 private:
  void wait(int options);

  int said_;         ///< a file in memory: a pipe would have to be emptied, or the program waits
  pid_t child_ = 0;  ///< 0: it has ended
  int status_ = 0;
};

}  // namespace repose
