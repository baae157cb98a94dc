#include "run/finished_run.h"

#include <filesystem>
#include <limits>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "comm/agreement.h"
#include "files/shared_file.h"
#include "run/restart.h"

namespace repose {

bool is_finished(const Communicator& comm, const std::string& directory, const std::string& resolved_deck) {
  const std::string path = directory + "/summary.json";
  int there = 0;
  if (comm.is_root()) there = std::filesystem::exists(path) ? 1 : 0;
  comm.broadcast(there);
  if (there == 0) return false;
  const std::string text = read_shared_file(comm, path);
  const nlohmann::json summary = nlohmann::json::parse(text, nullptr, false);
  if (!summary.is_object() || !summary.contains("deck") || !summary["deck"].is_string()) {
    throw FileError(fmt::format("{}: is no summary of a run; remove it to begin anew", path));
  }
  refuse_other_deck(directory, summary["deck"].get<std::string>(), resolved_deck,
                    std::numeric_limits<std::size_t>::max());
  return true;
}

}  // namespace repose
