#pragma once

#include <optional>
#include <string>

#include "comm/communicator.h"
#include "files/directory_lock.h"

namespace repose {

/// What writes a directory of results.
enum class ResultsOf { run, calibration, sensitivity, validation };

/// DeckError when the directory holds results of another kind: they would be mixed, and some of them replaced.
void refuse_other_results(const std::string& directory, ResultsOf kind);

/// Collective. A directory of results, made if it is not there, and kept from other jobs as long as this lives: they
/// would spoil each other's files. FileError when another job has it; throws as refuse_other_results does.
class ResultsDirectory {
 public:
  ResultsDirectory(const Communicator& comm, const std::string& directory, ResultsOf kind);

 private:
  std::optional<DirectoryLock> lock_;  ///< on rank 0
};

}  // namespace repose
