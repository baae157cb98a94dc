#pragma once

#include "thermal/tool.h"

namespace repose::thermal {

/// `repose thermal sensor`: errors of readings against the literature beside those that were printed for them, and
/// readings with mica at temperature corrected by the difference between mica and kapton at room temperature.
ToolResult sensor_tool(const ToolInput& input);

/// All keys of its deck, as `repose keys` prints them.
std::string sensor_keys();

}  // namespace repose::thermal
