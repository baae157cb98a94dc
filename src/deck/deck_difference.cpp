#include "deck/deck_difference.h"

#include <map>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include "base/error.h"
#include "deck/overrides.h"
#include "deck/read_deck.h"
#include "deck/resolved_deck.h"

namespace repose {
namespace {

using Values = std::map<std::string, std::string>;

std::string text_of(const toml::node& node) {
  if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
  if (const toml::array* array = node.as_array()) {
    std::vector<std::string> texts;
    for (const toml::node& element : *array) texts.push_back(text_of(element));
    return fmt::format("[{}]", fmt::join(texts, ", "));
  }
  std::ostringstream text;
  node.visit([&](const auto& value) { text << value; });
  return text.str();
}

void flatten(const toml::node& node, const std::string& key, Values& values) {
  if (const toml::table* table = node.as_table()) {
    for (const auto& [name, value] : *table) {
      const std::string inner(name.str());
      flatten(value, key.empty() ? inner : fmt::format("{}.{}", key, inner), values);
    }
  } else if (const toml::array* array = node.as_array(); array != nullptr && array->is_array_of_tables()) {
    for (std::size_t i = 0; i < array->size(); ++i) flatten(*array->get(i), fmt::format("{}[{}]", key, i), values);
  } else {
    values[key] = text_of(node);
  }
}

Values values_of(const std::string& deck) {
  try {
    Values values;
    flatten(toml::parse(deck), "", values);
    return values;
  } catch (const toml::parse_error& error) {
    throw DeckError(fmt::format("a resolved deck is no TOML: {}", error.description()));
  }
}

/// As this version reads and writes it.
std::string as_read(const std::string& deck) { return resolved_deck(read_deck(deck, "deck.resolved.toml", {})); }

std::string text_of_table(const toml::table& table) {
  std::ostringstream text;
  text << table;
  return text.str();
}

/// Whether a deck that does not say this key, such as "particles[0].spacing", is the same.
bool is_default(const std::string& deck, const std::string& key) {
  toml::table table = toml::parse(deck);
  const std::size_t dot = key.rfind('.');
  toml::table* section = dot == std::string::npos ? &table : table.at_path(key.substr(0, dot)).as_table();
  if (section == nullptr) return false;
  section->erase(dot == std::string::npos ? key : key.substr(dot + 1));
  try {
    return deck_differences(deck, as_read(text_of_table(table))).empty();
  } catch (const DeckError&) {
    return false;  // it must be said
  }
}

}  // namespace

std::vector<DeckDifference> deck_differences_beyond(const std::vector<std::string>& overrides,
                                                    const std::string& before, const std::string& now) {
  const std::string old_deck = as_read(before);
  const std::string new_deck = as_read(now);
  toml::table table = toml::parse(old_deck);
  apply_overrides(table, overrides);
  std::vector<DeckDifference> differences = deck_differences(text_of_table(table), new_deck);
  std::erase_if(differences,
                [&](const DeckDifference& d) { return is_default(old_deck, d.key) && is_default(new_deck, d.key); });
  return differences;
}

std::vector<DeckDifference> deck_differences(const std::string& before, const std::string& now) {
  Values old_values = values_of(before);
  Values new_values = values_of(now);
  Values all = old_values;
  all.insert(new_values.begin(), new_values.end());
  std::vector<DeckDifference> differences;
  for (const auto& [key, value] : all) {
    if (old_values[key] != new_values[key]) differences.push_back({key, old_values[key], new_values[key]});
  }
  return differences;
}

}  // namespace repose
