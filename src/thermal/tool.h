#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "deck/overrides.h"
#include "deck/parse_toml.h"
#include "deck/reader.h"
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

/// Reads a deck whose keys describe(visitor, deck) lists (deck/schema_types.h). `check(deck, errors)` adds what
/// connects several keys. DeckError, with the place, on the first mistake.
template <class D, class Check>
D read_tool_deck(const ToolInput& input, Check&& check) {
  toml::table root = parse_toml(input.deck.bytes, input.deck.name);
  const Overridden overridden = apply_overrides(root, input.overrides);
  DeckErrors errors(input.deck.name);
  D deck;
  Reader reader(root, overridden, errors);
  describe(reader, deck);
  reader.finish();
  errors.throw_first();
  check(deck, errors);
  errors.throw_first();
  return deck;
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
