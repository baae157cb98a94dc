#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "deck/read_described.h"
#include "deck/key.h"

/// What the thermal tools have in common: a deck and data files in, a table and a JSON result out.
namespace repose::thermal {

using Json = nlohmann::ordered_json;

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

struct ToolResult {
  std::string text;              ///< what the user sees
  Json json;                     ///< every figure
  std::vector<DataFile> tables;  ///< further files to write beside the JSON
};

/// As read_described.
template <class D, class Check>
D read_tool_deck(const ToolInput& input, Check&& check) {
  return read_described<D>(input.deck.bytes, input.deck.name, input.overrides, check);
}

}  // namespace repose::thermal
