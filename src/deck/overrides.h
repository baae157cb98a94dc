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

/// The message that refuses an override, "--set KEY=...", as one of the file that asked for it: with the path and the
/// first line of its text that has the key. Another message, and a key that is not there, are left as they are.
std::string told_of_file(const std::string& message, const std::string& path, const std::string& text);

}  // namespace repose
