#pragma once

#include <set>
#include <string>

namespace repose {

/// The sections of a deck of a run that can be repeated, with those around them: "wall", "wall.motion".
const std::set<std::string>& repeated_sections();

}  // namespace repose
