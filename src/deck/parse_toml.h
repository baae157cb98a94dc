#pragma once

#include <string>

#include <toml++/toml.h>

namespace repose {

/// The TOML table in `text`. DeckError "path:line:column: ..." on a syntax error.
toml::table parse_toml(const std::string& text, const std::string& path);

}  // namespace repose
