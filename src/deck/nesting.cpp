#include "deck/nesting.h"

#include <algorithm>

namespace repose {
namespace {

/// The text behind the string that it begins with, which may be of several lines.
std::string_view after_string(std::string_view text) {
  const char quote = text.front();
  const bool escapes = quote == '"';
  const std::string_view three = escapes ? R"(""")" : "'''";
  const bool is_long = text.starts_with(three);
  text.remove_prefix(is_long ? 3 : 1);
  while (!text.empty()) {
    if (escapes && text.front() == '\\') {
      text.remove_prefix(std::min<std::size_t>(2, text.size()));
    } else if (is_long ? text.starts_with(three) : text.front() == quote || text.front() == '\n') {
      text.remove_prefix(is_long ? 3 : 1);
      while (is_long && text.starts_with(quote)) text.remove_prefix(1);  // one or two quotes may stand before the three
      return text;
    } else {
      text.remove_prefix(1);
    }
  }
  return text;
}

}  // namespace

bool has_deep_key(std::string_view toml) {
  constexpr std::string_view ends_key = "=,\n[]{}";
  int parts = 1;
  while (!toml.empty()) {
    const char c = toml.front();
    if (c == '"' || c == '\'') {
      toml = after_string(toml);
      continue;
    }
    if (c == '#') {
      toml.remove_prefix(std::min(toml.find('\n'), toml.size()));
      continue;
    }
    if (c == '.') ++parts;
    if (ends_key.find(c) != std::string_view::npos) parts = 1;
    if (parts > most_key_parts) return true;
    toml.remove_prefix(1);
  }
  return false;
}

}  // namespace repose
