#pragma once

#include "thermal/tool.h"

namespace repose::thermal {

/// `repose thermal bed`: the conductivity of a bed by Zehner, Bauer and Schluender over a range of temperatures, what
/// its parts contribute, what the uncertainty of the densities makes of it, and how far given measurements deviate.
ToolResult bed_tool(const ToolInput& input);

/// All keys of its deck, as `repose keys` prints them.
std::string bed_keys();

}  // namespace repose::thermal
