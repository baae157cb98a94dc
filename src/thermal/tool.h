#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "thermal/tool_input.h"

/// What the thermal tools have in common: a deck and data files in, a table and a JSON result out.
namespace repose::thermal {

using Json = nlohmann::ordered_json;

struct ToolResult {
  std::string text;              ///< what the user sees
  Json json;                     ///< every figure
  std::vector<DataFile> tables;  ///< further files to write beside the JSON
};

}  // namespace repose::thermal
