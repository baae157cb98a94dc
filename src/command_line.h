#pragma once

#include <optional>
#include <string>
#include <vector>

namespace repose {

/// What the program was asked to do.
struct CommandLine {
  enum class Action { run, check, measure, keys, version, none };

  Action action = Action::none;
  std::string text;                    ///< none: the help to print
  std::string deck;                    ///< run, check, measure: path of the deck
  std::string file;                    ///< measure: path of the snapshot or CSV
  std::string output;                  ///< run, measure: directory of the results; measure: may be empty
  std::vector<std::string> overrides;  ///< run, check, measure: "key=value" of each --set, in order
  std::string vector_level = "auto";   ///< run: auto, sse2, avx2, avx512
  bool quiet = false;                  ///< run: no progress lines
  bool restart = false;                ///< run: go on from the newest checkpoint
  std::optional<double> time_limit;    ///< run: s of wall time
};

/// Parses the command line and prints nothing. Throws DeckError (exit code 2) with one line when it is wrong.
CommandLine parse_command_line(int argc, char** argv);

}  // namespace repose
