#include "deck/overrides.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <sstream>

#include "base/error.h"
#include "base/trimmed.h"
#include "deck/nearest.h"
#include "deck/nesting.h"
#include "deck/repeated_sections.h"

namespace repose {
namespace {

/// Whether the part, of this path, is a [[section]]: one that a deck of a run may have, or one that this deck has.
bool is_repeated(const toml::table& table, const std::string& part, const std::string& path) {
  if (const toml::array* array = table.get_as<toml::array>(part); array != nullptr && array->is_array_of_tables()) {
    return true;
  }
  return repeated_sections().contains(without_indices(path));
}

/// As TOML wants it; a deck with other bytes in its texts could not be written.
bool is_utf8(const std::string& text) {
  std::string quoted = "'";
  std::copy_if(text.begin(), text.end(), std::back_inserter(quoted), [](char c) { return (c & 0x80) != 0; });
  try {
    return !toml::parse("x = " + quoted + "'").empty();
  } catch (const toml::parse_error&) {
    return false;
  }
}

[[noreturn]] void fail(const std::string& set_text, const std::string& message) {
  throw DeckError(fmt::format("--set {}: {}", set_text, message));
}

std::vector<std::string> split_key(const std::string& key) {
  std::vector<std::string> parts;
  std::size_t start = 0;
  while (true) {
    const std::size_t dot = key.find('.', start);
    parts.emplace_back(trimmed(std::string_view(key).substr(start, dot - start), " \t"));
    if (dot == std::string::npos) return parts;
    start = dot + 1;
  }
}

/// The names by which an element of a repeated section can be chosen.
std::vector<std::string> names_of(const toml::table& element) {
  if (const auto name = element["name"].value<std::string>()) return {*name};
  const auto a = element["materials"][0].value<std::string>();
  const auto b = element["materials"][1].value<std::string>();
  if (a && b) return {*a + "-" + *b, *b + "-" + *a};
  return {};
}

std::size_t find_element(const toml::array& array, const std::string& section, const std::string& which,
                         const std::string& set_text) {
  std::vector<std::string> all_names;
  for (std::size_t i = 0; i < array.size(); ++i) {
    if (!array.get(i)->is_table()) continue;
    for (const std::string& name : names_of(*array.get(i)->as_table())) {
      if (name == which) return i;
      all_names.push_back(name);
    }
  }
  std::size_t index = 0;
  const auto result = std::from_chars(which.data(), which.data() + which.size(), index);
  const bool is_index = result.ec == std::errc{} && result.ptr == which.data() + which.size();
  if (is_index && index < array.size()) return index;
  if (is_index || all_names.empty()) {
    fail(set_text,
         fmt::format("there is no [[{0}]] \"{1}\"; the deck has {2}, counted from 0", section, which, array.size()));
  }
  fail(set_text,
       fmt::format("there is no [[{}]] \"{}\"; the nearest is \"{}\"", section, which, nearest(which, all_names)));
}

void assign(toml::table& table, const std::string& key, const std::string& value) {
  try {
    toml::table parsed = toml::parse("value = " + value);
    if (parsed.size() == 1) {
      parsed.get("value")->visit([&](auto& node) { table.insert_or_assign(key, std::move(node)); });
      return;
    }
  } catch (const toml::parse_error&) {
    // not TOML: a text without its quotes, such as 440 um
  }
  table.insert_or_assign(key, value);
}

/// The path of what it has set.
std::string apply(toml::table& root, const std::string& set_text, Overridden& overridden) {
  const std::size_t equals = set_text.find('=');
  if (equals == std::string::npos) fail(set_text, "write key=value, such as time.step=2e-6");
  if (has_deep_key(set_text)) fail(set_text, fmt::format("a key has more than {} parts", most_key_parts));
  if (!is_utf8(set_text)) fail(set_text, "write it in UTF-8");
  const std::vector<std::string> parts = split_key(set_text.substr(0, equals));
  if (std::find(parts.begin(), parts.end(), "") != parts.end()) fail(set_text, "the key has an empty part");

  toml::table* table = &root;
  std::string path;
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
    path = child(path, parts[i]);
    const std::string& part = parts[i];
    if (is_repeated(*table, part, path)) {
      toml::array* array = table->get_as<toml::array>(part);
      if (array == nullptr) fail(set_text, fmt::format("the deck has no [[{}]]", path));
      if (parts.size() < i + 3) {
        fail(set_text, fmt::format("say which [[{0}]]: {0}.0.{1}=... or {0}.NAME.{1}=...", path, parts[i + 1]));
      }
      const std::size_t index = find_element(*array, path, parts[i + 1], set_text);
      table = array->get_as<toml::table>(index);
      path = child(path, index);
      ++i;
      if (table == nullptr) fail(set_text, fmt::format("\"{}\" is not a section", path));
      continue;
    }
    if (!table->contains(parts[i])) {
      table->insert(parts[i], toml::table{});
      overridden[path] = set_text;
    }
    table = table->get_as<toml::table>(parts[i]);
    if (table == nullptr) fail(set_text, fmt::format("\"{}\" is a value and has no keys", path));
  }
  assign(*table, parts.back(), std::string(trimmed(std::string_view(set_text).substr(equals + 1), " \t")));
  path = child(path, parts.back());
  overridden[path] = set_text;
  return path;
}

}  // namespace

Overridden apply_overrides(toml::table& root, const std::vector<std::string>& overrides) {
  Overridden overridden;
  for (const std::string& set_text : overrides) apply(root, set_text, overridden);
  return overridden;
}

std::vector<std::string> override_paths(toml::table root, const std::vector<std::string>& overrides) {
  std::vector<std::string> paths;
  Overridden overridden;
  for (const std::string& set_text : overrides) paths.push_back(apply(root, set_text, overridden));
  return paths;
}

std::optional<std::string> place_of(const std::string& word, const std::string& path, const std::string& text) {
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (!line.starts_with('#') && line.find(word) != std::string::npos) return fmt::format("{}:{}", path, number);
  }
  return {};
}

std::string told_of_file(const std::string& message, const std::vector<std::string>& overrides, const std::string& path,
                         const std::string& text) {
  for (const std::string& set_text : overrides) {
    if (!message.starts_with(fmt::format("--set {}: ", set_text))) continue;
    std::optional<std::string> place = place_of(set_text, path, text);
    if (!place) place = place_of(set_text.substr(0, set_text.find('=')), path, text);
    if (place) return fmt::format("{}: {}", *place, message.substr(std::string_view("--set ").size()));
  }
  return message;
}

}  // namespace repose
