#pragma once

#include "thermal/tool.h"

namespace repose::thermal {

/// `repose thermal network`: the conductivity of simulated beds, from snapshots of repose or CSV with the header
/// x,y,z,radius: their network of contacts and near gaps over a range of temperatures, beside the model of Zehner,
/// Bauer and Schluender at the same porosity.
ToolResult network_tool(const ToolInput& input);

/// All keys of its deck, as `repose keys` prints them.
std::string network_keys();

}  // namespace repose::thermal
