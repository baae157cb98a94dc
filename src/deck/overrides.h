#pragma once

#include <string>
#include <vector>

#include "deck/reader.h"

namespace repose {

/// Replaces or adds each `key=value` in the parsed deck; a [[section]] is chosen by index or name
/// ("material.0.density", "wall.lid.present", "pair.glass-steel.restitution"). The value is TOML, else a bare text.
/// Returns what came from where. Throws DeckError for a malformed override or a section that is not there; whether the
/// key exists is left to the Reader.
Overridden apply_overrides(toml::table& root, const std::vector<std::string>& overrides);

}  // namespace repose
