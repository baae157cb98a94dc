#pragma once

#include <optional>
#include <string>
#include <vector>

#include "deck/reader.h"

namespace repose {

/// Replaces or adds each `key=value` in the parsed deck; a [[section]] is chosen by index or name
/// ("material.0.density", "wall.lid.present", "pair.glass-steel.restitution"). The value is TOML, else a bare text.
/// Returns what came from where. Throws DeckError for a malformed override or a section that is not there; whether the
/// key exists is left to the Reader.
Overridden apply_overrides(toml::table& root, const std::vector<std::string>& overrides);

/// What each override sets, by one spelling: "pair.0.restitution", whichever of the pair's names it takes. Throws as
/// apply_overrides.
std::vector<std::string> override_paths(toml::table root, const std::vector<std::string>& overrides);

/// "path:line" of the first line of a file's text that has the word and is no comment; nothing when none has.
std::optional<std::string> place_of(const std::string& word, const std::string& path, const std::string& text);

/// The message that refuses one of these overrides, "--set KEY=VALUE: ...", as one of the file that asked for it: with
/// the path and the first line of its text that has the override, or else its key. Another message, and an override
/// that the text does not have, are left as they are.
std::string told_of_file(const std::string& message, const std::vector<std::string>& overrides, const std::string& path,
                         const std::string& text);

}  // namespace repose
