#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "deck/read_described.h"
#include "deck/schema_types.h"

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

/// `count` values from `first` to `last`, both included; one value is `first`.
inline std::vector<double> evenly_spaced(double first, double last, std::int64_t count) {
  std::vector<double> values;
  for (std::int64_t i = 0; i < count; ++i) {
    const double share = count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) : 0.0;
    values.push_back(first + share * (last - first));
  }
  return values;
}

}  // namespace repose::thermal
