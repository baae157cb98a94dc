#pragma once

#include <string>
#include <utility>
#include <vector>

#include "files/read_file.h"
#include "import/imported_scene.h"

namespace repose {

/// What a script has become.
struct ImportedDeck {
  std::string deck;                                        ///< TOML
  std::vector<std::pair<std::string, std::string>> files;  ///< beside it: name and bytes
  std::vector<Note> missing;                               ///< commands without a counterpart
  std::vector<Note> warnings;                              ///< what is to be looked at in the deck
};

/// The deck of an input script of LIGGGHTS, with comments that name the line of each part, and what has no counterpart.
/// `script` is the script's name, `read_file` reads it and what it names; `dump`, if not empty, is a dump whose grains
/// are there at the start in place of those that the script inserts; `variables` are "name=value". The deck has passed
/// the checks of `repose check`. DeckError as `file:line: what` for a script that is malformed or whose simulation has
/// no counterpart as a whole; FileError when a file cannot be read.
ImportedDeck import_script(const std::string& script, const ReadFile& read_file,
                           const std::vector<std::string>& variables, const std::string& dump);

/// Name of the deck of a script: "in.chute" and "chute.in" become "chute.toml".
std::string deck_name(const std::string& script);

}  // namespace repose
