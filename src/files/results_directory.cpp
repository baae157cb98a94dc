#include "files/results_directory.h"

#include <filesystem>

#include <fmt/core.h>

#include "base/error.h"
#include "comm/agreement.h"
#include "files/directory.h"

namespace repose {

void refuse_other_results(const std::string& directory, ResultsOf kind) {
  struct Mark {
    ResultsOf kind;
    const char* file;  ///< there as soon as there are results; of a validation, once its cases are done
    const char* name;
  };
  constexpr Mark marks[] = {{ResultsOf::run, "deck.resolved.toml", "run"},
                            {ResultsOf::calibration, "calibration.toml", "calibration"},
                            {ResultsOf::sensitivity, "sensitivity.toml", "sensitivity study"},
                            {ResultsOf::validation, "validation.json", "validation"}};
  for (const Mark& mark : marks) {
    if (mark.kind == kind || !std::filesystem::exists(fmt::format("{}/{}", directory, mark.file))) continue;
    throw DeckError(fmt::format("{}: holds the results of a {}; name another directory", directory, mark.name));
  }
}

ResultsDirectory::ResultsDirectory(const Communicator& comm, const std::string& directory, ResultsOf kind) {
  agree_after_root(comm, [&] {
    create_output_directory(directory);
    lock_.emplace(directory);
    refuse_other_results(directory, kind);
  });
}

}  // namespace repose
