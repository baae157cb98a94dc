#include "deck/parse_toml.h"

#include <fmt/core.h>

#include "base/error.h"
#include "deck/nesting.h"

namespace repose {
namespace {

/// What to do about the syntax errors that people make most.
std::string remedy(const std::string& description) {
  const auto says = [&](const char* text) { return description.find(text) != std::string::npos; };
  if (says("as array-of-tables"))
    return "; give it once; a section such as [[wall.motion]] stands behind the [[wall]] it belongs to";
  if (says("cannot redefine")) return "; give it once";
  if (says("could not determine value type")) return "; a text needs quotes";
  if (says("expected a comment or whitespace"))
    return "; one key per line, and a value with a unit is a text, as \"5 mm\"";
  return {};
}

}  // namespace

toml::table parse_toml(const std::string& text, const std::string& path) {
  if (has_deep_key(text)) throw DeckError(fmt::format("{}: a key has more than {} parts", path, most_key_parts));
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    const std::string description(error.description());
    throw DeckError(fmt::format("{}:{}:{}: TOML syntax: {}{}", path, error.source().begin.line,
                                error.source().begin.column, description, remedy(description)));
  }
}

}  // namespace repose
