#pragma once

#include <optional>
#include <string>
#include <vector>

#include "commands/options.h"
#include "run/run_file.h"

namespace repose {

/// Seconds of "HH:MM:SS" or "D-HH:MM:SS", as batch systems write time limits. DeckError for anything else.
double seconds_of_time_limit(const std::string& limit);

/// What the commands that run decks are given.
struct StudyRequest {
  std::string file;  ///< the deck, or the file that says what to run
  std::vector<std::string> overrides;
  std::string output;
  std::string vector_level = "auto";
  std::optional<double> time_limit;  ///< s of wall time
  bool quiet = false;

  /// `name` is how the help calls the file, `meaning` what it says of it.
  void declare(Options& options, const std::string& name, const std::string& meaning);
  /// Collective. DeckError on all ranks when the processor of one lacks the vector level.
  RunRequest run_request(const Communicator& world) const;
};

}  // namespace repose
