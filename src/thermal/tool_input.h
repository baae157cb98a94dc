#pragma once

#include <string>
#include <vector>

namespace repose::thermal {

/// A file as its tool gets it.
struct DataFile {
  std::string name;  ///< for messages
  std::string bytes;
};

struct ToolInput {
  DataFile deck;                       ///< TOML
  std::vector<std::string> overrides;  ///< "key=value" of each --set
  std::vector<DataFile> files;         ///< data, for the tools that take some
};

}  // namespace repose::thermal
