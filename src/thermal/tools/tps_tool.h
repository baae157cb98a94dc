#pragma once

#include "thermal/tool.h"

namespace repose::thermal {

/// `repose thermal tps`: evaluates transients in CSV files: conductivity, diffusivity and heat capacity with their
/// uncertainties, and every criterion of thesis section 5.2; with several files their mean and scatter, too.
ToolResult tps_tool(const ToolInput& input);

/// `repose thermal synthesise`: makes up the transient of [synthetic] as transient.csv.
ToolResult synthesise_tool(const ToolInput& input);

}  // namespace repose::thermal
