#pragma once

#include <functional>
#include <string>
#include <vector>

#include "files/read_file.h"
#include "import/script_command.h"

namespace repose {

/// Calls visit(command) for the commands of a script of LIGGGHTS or LAMMPS in the order in which they are carried out:
/// continued lines joined, comments taken off, variables replaced, includes, loops (next, jump, label) and conditions
/// (if) followed. `file` is its name, `read_file` reads it and what it includes; `variables` ("name=value") are there
/// from the start. What only says something (print, thermo_style, ...) keeps its variables. DeckError at the line that
/// cannot be followed, or beyond `most_commands`, as in a loop without end; FileError when a file cannot be read.
void read_script(const std::string& file, const ReadFile& read_file, const std::vector<std::string>& variables,
                 const std::function<void(const ScriptCommand&)>& visit, std::size_t most_commands = 1000000);

/// The words of a line; quotes hold some together and are taken off. DeckError when one is not closed.
std::vector<std::string> split_words(const std::string& line, const Place& place);

}  // namespace repose
