#pragma once

#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace repose {

/// Where a result comes from: the program, how it was compiled, the libraries that it runs with.
struct BuildInfo {
  std::string version;
  std::string commit;  ///< of git, with "-dirty" when files were changed; "unknown" outside a repository
  std::string compiler;
  std::string flags;
  std::string mpi;
  std::string hdf5;
  std::string vector_level;
};

/// This build; `vector_level` names the instruction set that the pair loop chose on this machine.
BuildInfo build_info(const std::string& vector_level);

/// The members as (name, text), in the order above.
std::vector<std::pair<std::string, std::string>> build_fields(const BuildInfo& build);

nlohmann::ordered_json json_of(const BuildInfo& build);

/// What `repose --version` prints: "repose <version>" and a line per further field.
std::string version_text(const std::string& vector_level);

}  // namespace repose
