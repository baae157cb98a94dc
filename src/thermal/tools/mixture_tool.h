#pragma once

#include "thermal/tool.h"

namespace repose::thermal {

/// `repose thermal mixture`: heat capacity of a bed in air, with and without the air, whether the air may be neglected,
/// and the specific heat of the grains from a measured volumetric one.
ToolResult mixture_tool(const ToolInput& input);

/// All keys of its deck, as `repose keys` prints them.
std::string mixture_keys();

}  // namespace repose::thermal
