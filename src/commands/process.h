#pragma once

#include <memory>
#include <optional>
#include <string>

#include "comm/communicator.h"
#include "run/stop_request.h"

namespace repose {

/// The process that carries out a command. MPI takes a third of a second to start, so it is started for commands that
/// simulate, and for all when a launcher has started several processes: one of them alone may speak.
class Process {
 public:
  enum class Need { alone, ranks };
  /// The time limit counts from here.
  Process(int* argc, char*** argv) : argc_(argc), argv_(argv) {}

  /// Starts MPI if that is needed; to be called once, before `ranks`.
  void begin(Need need);
  /// All processes that the launcher has started; this one alone when there was none.
  const Communicator& ranks() const { return *ranks_; }
  /// Prints a text on rank 0.
  void say(const std::string& text) const;
  /// What a run asks whether it has to stop, within the time limit in s, if there is one.
  StopAsked stop_asked(std::optional<double> time_limit);

 private:
  int* argc_;
  char*** argv_;
  StopRequest stop_;
  std::unique_ptr<MpiGuard> mpi_;
  std::unique_ptr<Communicator> ranks_;
};

}  // namespace repose
