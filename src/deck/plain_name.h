#pragma once

#include <algorithm>
#include <cctype>
#include <string>

#include <fmt/core.h>

#include "deck/deck_errors.h"

namespace repose {

/// Notes a name that cannot be that of a folder on every system.
inline void check_plain_name(const std::string& name, const std::string& key, DeckErrors& errors) {
  const bool is_plain = !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '-';
  });
  if (!is_plain) errors.add(key, fmt::format("\"{}\" names a folder: letters, digits, _ and - are allowed", name));
}

}  // namespace repose
