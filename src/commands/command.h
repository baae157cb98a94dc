#pragma once

#include <memory>
#include <string>
#include <vector>

#include "commands/options.h"
#include "commands/process.h"

namespace repose {

/// A command of the program: one file each in this folder, which ends with the function that makes it.
class Command {
 public:
  virtual ~Command() = default;
  /// Names what it takes; `carry_out` finds the values in its members.
  virtual void declare(Options&) {}
  /// Collective. Throws what carries an exit code (base/error.h).
  virtual void carry_out(Process& process) = 0;

 protected:
  Command() = default;
  Command(const Command&) = default;
  Command& operator=(const Command&) = default;
};

/// How the command line knows a command.
struct CommandEntry {
  std::string name;     ///< "run"; two words, such as "thermal bed", for one of a group
  std::string meaning;  ///< in the help
  std::unique_ptr<Command> (*make)();
  Process::Need need = Process::Need::alone;
};

/// All commands, in the order of the help.
const std::vector<CommandEntry>& command_entries();
/// The meaning in the help of a group of commands with two words, such as "thermal".
std::string group_meaning(const std::string& group);

}  // namespace repose
