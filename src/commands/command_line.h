#pragma once

#include <memory>

#include "commands/command.h"

namespace repose {

/// What the program was asked to do.
struct CommandLine {
  std::unique_ptr<Command> command;  ///< for --help and --version, too
  Process::Need need = Process::Need::alone;
};

/// Parses the command line and prints nothing. Throws DeckError (exit code 2) with one line when it is wrong.
CommandLine parse_command_line(int argc, char** argv);

}  // namespace repose
