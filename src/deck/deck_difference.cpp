#include "deck/deck_difference.h"

#include <map>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include "base/error.h"

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

}  // namespace

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
