#pragma once

#include <optional>
#include <string>
#include <vector>

namespace repose {

/// What the program was asked to do.
struct CommandLine {
  enum class Action {
    run,
    check,
    measure,
    info,
    export_file,
    validate,
    calibrate,
    estimate,
    sensitivity,
    thermal,
    keys,
    version,
    none
  };

  Action action = Action::none;
  std::string text;                ///< none: the help to print
  std::string deck;                ///< path of the deck, or of what validate, calibrate, ... read
  std::string file;                ///< measure, info, export: path of what is read; estimate: the directory
  std::string format;              ///< export: vtp or csv
  std::string tool;                ///< thermal: which of its tools, or compare
  std::vector<std::string> files;  ///< thermal: paths of data, for the tools that take some
  std::string output;  ///< directory of the results; measure, thermal: may be empty; export: path of the file
  std::vector<std::string> cases;      ///< validate: names of the only ones to run
  std::vector<std::string> overrides;  ///< "key=value" of each --set, in order
  std::string vector_level = "auto";   ///< auto, sse2, avx2, avx512
  bool quiet = false;                  ///< no progress lines
  bool restart = false;                ///< run: go on from the newest checkpoint
  std::optional<double> time_limit;    ///< s of wall time
};

/// Parses the command line and prints nothing. Throws DeckError (exit code 2) with one line when it is wrong.
CommandLine parse_command_line(int argc, char** argv);

}  // namespace repose
