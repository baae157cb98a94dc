#pragma once

#include "thermal/tool.h"

namespace repose::thermal {

/// `repose compare A.csv B.csv`: repeated measurements before and after cycling, or cold and hot: for each figure of
/// the deck whether the two are equivalent, and the thermal expansion of an orifice against the smallest grain.
ToolResult compare_tool(const ToolInput& input);

/// All keys of its deck, as `repose keys` prints them.
std::string compare_keys();

}  // namespace repose::thermal
