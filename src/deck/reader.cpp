#include "deck/reader.h"

#include <algorithm>
#include <cmath>

#include <fmt/ranges.h>

#include "deck/nearest.h"

namespace repose {
namespace {

std::string what_it_is(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a section";
    case toml::node_type::array:
      return fmt::format("a list of {}", node.as_array()->size());
    case toml::node_type::string:
      return fmt::format("the text \"{}\"", node.as_string()->get());
    case toml::node_type::integer:
      return fmt::format("the number {}", node.as_integer()->get());
    case toml::node_type::floating_point:
      return fmt::format("the number {}", node.as_floating_point()->get());
    case toml::node_type::boolean:
      return node.as_boolean()->get() ? "true" : "false";
    default:
      return "a date or time";
  }
}

/// The key as its line names it: without the section, but with the index of a list element.
std::string short_name(std::string_view path) {
  std::size_t end = path.size();
  while (true) {
    const std::size_t dot = path.substr(0, end).rfind('.');
    const std::size_t start = dot == std::string_view::npos ? 0 : dot + 1;
    if (start == 0 || path[start] < '0' || path[start] > '9') return std::string(path.substr(start));
    end = dot;
  }
}

std::string number_kind(Unit unit) {
  if (unit == Unit::none) return "a number";
  return fmt::format("a number in {0} or a text with a unit such as \"1 {0}\"", symbol(unit));
}

}  // namespace

std::string without_indices(std::string_view path) {
  std::string names;
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('.', begin), path.size());
    const std::string_view part = path.substr(begin, end - begin);
    const bool is_index = part.find_first_not_of("0123456789") == std::string_view::npos;
    if (!is_index) names += (names.empty() ? "" : ".") + std::string(part);
    begin = end + 1;
  }
  return names;
}

Reader::Reader(const toml::table& root, const Overridden& overridden, DeckErrors& errors)
    : overridden_(overridden), errors_(errors) {
  levels_.push_back({&root, "", "the deck", errors.count(), {}, {}, false});
}

KeyPlace Reader::locate(const std::string& path, const toml::source_region& source) {
  std::string around = path;
  while (!around.empty()) {
    if (const auto found = overridden_.find(around); found != overridden_.end()) return {0, 0, found->second};
    const auto dot = around.rfind('.');
    around.resize(dot == std::string::npos ? 0 : dot);
  }
  return {static_cast<int>(source.begin.line), static_cast<int>(source.begin.column), {}};
}

const toml::node* Reader::find(std::string_view key, const Presence& presence, std::string_view meaning) {
  Level& level = levels_.back();
  level.known.emplace_back(key);
  const auto found = level.table->find(key);
  if (found == level.table->end()) {
    if (presence.is_required && presence.applies) level.missing.push_back(fmt::format("\"{}\" ({})", key, meaning));
    return nullptr;
  }
  const std::string path = child(level.path, key);
  if (!presence.applies) {
    if (level.type_is_unknown) return nullptr;
    errors_.add(locate(path, found->first.source()),
                fmt::format("\"{}\" of {} is only allowed {}{}; remove it", key, level.title,
                            presence.condition.starts_with("without ") ? "" : "with ", presence.condition));
    return nullptr;
  }
  errors_.locate(path, locate(path, found->second.source()));
  return &found->second;
}

const toml::array* Reader::find_sections(std::string_view name, const Presence& presence, std::string_view meaning) {
  const toml::node* node = find(name, presence, meaning);
  if (node == nullptr) return nullptr;
  const std::string path = child(levels_.back().path, name);
  if (!node->is_array()) {
    errors_.add(path, fmt::format("\"{}\" is {}; write [[{}]], which can be repeated", path, what_it_is(*node),
                                  without_indices(path)));
    return nullptr;
  }
  if (node->as_array()->empty() && presence.is_required) {
    errors_.add(path, fmt::format("\"{0}\" is empty; the deck needs at least one [[{0}]]", path));
  }
  return node->as_array();
}

bool Reader::enter(const toml::node& node, const std::string& path, const std::string& title) {
  errors_.locate(path, locate(path, node.source()));
  if (!node.is_table()) {
    errors_.add(path, fmt::format("\"{}\" is {}; it must be the section {}", path, what_it_is(node), title));
    return false;
  }
  levels_.push_back({node.as_table(), path, title, errors_.count(), {}, {}, false});
  return true;
}

void Reader::leave() {
  const Level& level = levels_.back();
  const auto contains = [](const std::vector<std::string>& keys, std::string_view key) {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
  };
  for (const auto& [key, node] : *level.table) {
    const std::string_view name = key.str();
    if (contains(level.known, name)) continue;
    const std::string hint = !node.is_table() && contains(levels_.front().known, name)
                                 ? "it belongs before the first section"
                                 : fmt::format("the nearest key is \"{}\"", nearest(name, level.known));
    errors_.add(locate(child(level.path, name), key.source()),
                fmt::format("unknown key \"{}\" in {}; {}", name, level.title, hint));
  }
  // A key that is missing beside a wrong one is most likely the wrong one, so only that is reported.
  if (errors_.count() == level.errors_before && !level.missing.empty()) {
    errors_.add(level.path, fmt::format("{} lacks {}", level.title, fmt::join(level.missing, ", ")));
  }
  levels_.pop_back();
}

void Reader::refuse(const std::string& path, const toml::node& node, std::string_view wanted) {
  errors_.add(path, fmt::format("\"{}\" must be {}, not {}", short_name(path), wanted, what_it_is(node)));
}

const toml::array* Reader::list(const toml::node& node, const std::string& path, std::size_t length,
                                std::string_view wanted) {
  errors_.locate(path, locate(path, node.source()));
  const toml::array* array = node.as_array();
  if (array == nullptr && node.is_string() && wanted.starts_with("list of ") && !wanted.ends_with(']')) {
    const std::string& text = node.as_string()->get();
    const bool is_number = text.find_first_not_of("+-.0123456789eE_ ") == std::string::npos;
    errors_.add(path, fmt::format("\"{}\" must be a {}, not {}; write {}", short_name(path), wanted, what_it_is(node),
                                  is_number ? fmt::format("[{}]", text) : fmt::format("[\"{}\"]", text)));
    return nullptr;
  }
  if (array == nullptr || (length != any_length && array->size() != length)) {
    refuse(path, node, wanted.starts_with('[') ? fmt::format("{}", wanted) : fmt::format("a {}", wanted));
    return nullptr;
  }
  return array;
}

bool Reader::in_range(double value, const std::string& path, const Rule& rule) {
  if (!std::isfinite(value)) {
    errors_.add(path, fmt::format("\"{}\" must be finite, not {}", short_name(path), value));
    return false;
  }
  if (rule.range.contains(value)) return true;
  errors_.add(
      path, fmt::format("\"{}\" = {} is out of range; it must be {}{}", short_name(path), value, range_text(rule.range),
                        rule.unit == Unit::none ? "" : fmt::format(" (in {})", symbol(rule.unit))));
  return false;
}

bool Reader::read_choice(const toml::node& node, const std::string& path, const std::vector<std::string>& names,
                         std::size_t& choice) {
  std::string text;
  const std::size_t errors_before = errors_.count();
  read(node, path, {Unit::none, any_value}, text);
  if (errors_.count() != errors_before) return false;
  choice = static_cast<std::size_t>(std::find(names.begin(), names.end(), text) - names.begin());
  if (choice < names.size()) return true;
  errors_.add(path, fmt::format("\"{}\" is no {}; it must be one of {}; the nearest is \"{}\"", text, short_name(path),
                                fmt::join(names, ", "), nearest(text, names)));
  return false;
}

void Reader::read(const toml::node& node, const std::string& path, const Rule& rule, double& value) {
  errors_.locate(path, locate(path, node.source()));
  double number = 0.0;
  if (node.is_string() && rule.unit != Unit::none) {
    const Quantity quantity = parse_quantity(node.as_string()->get(), rule.unit);
    if (!quantity.problem.empty()) {
      errors_.add(path, fmt::format("\"{}\": {}", short_name(path), quantity.problem));
      return;
    }
    number = quantity.value;
  } else if (node.is_number()) {
    number = node.is_integer() ? static_cast<double>(node.as_integer()->get()) : node.as_floating_point()->get();
  } else {
    return refuse(path, node, number_kind(rule.unit));
  }
  if (in_range(number, path, rule)) value = number;
}

void Reader::read(const toml::node& node, const std::string& path, const Rule& rule, std::int64_t& value) {
  errors_.locate(path, locate(path, node.source()));
  if (!node.is_integer()) return refuse(path, node, "an integer");
  const std::int64_t number = node.as_integer()->get();
  if (in_range(static_cast<double>(number), path, rule)) value = number;
}

void Reader::read(const toml::node& node, const std::string& path, const Rule& rule, std::uint64_t& value) {
  std::int64_t number = static_cast<std::int64_t>(value);
  read(node, path, rule, number);  // the ranges of unsigned members begin at 0 or above
  value = static_cast<std::uint64_t>(number);
}

void Reader::read(const toml::node& node, const std::string& path, const Rule&, bool& value) {
  errors_.locate(path, locate(path, node.source()));
  if (!node.is_boolean()) return refuse(path, node, "true or false");
  value = node.as_boolean()->get();
}

void Reader::read(const toml::node& node, const std::string& path, const Rule&, std::string& value) {
  errors_.locate(path, locate(path, node.source()));
  if (!node.is_string()) return refuse(path, node, "a text in quotes");
  value = node.as_string()->get();
}

void Reader::read(const toml::node& node, const std::string& path, const Rule& rule, Vec3& value) {
  const toml::array* array = list(node, path, 3, "[x, y, z]");
  if (array == nullptr) return;
  read(*array->get(0), child(path, std::size_t{0}), rule, value.x);
  read(*array->get(1), child(path, 1), rule, value.y);
  read(*array->get(2), child(path, 2), rule, value.z);
}

void Reader::read(const toml::node& node, const std::string& path, const Rule& rule, std::array<double, 2>& value) {
  const toml::array* array = list(node, path, 2, "[r, z]");
  if (array == nullptr) return;
  for (std::size_t i = 0; i < 2; ++i) read(*array->get(i), child(path, i), rule, value[i]);
}

void Reader::read(const toml::node& node, const std::string& path, const Rule& rule,
                  std::array<std::string, 2>& value) {
  const toml::array* array = list(node, path, 2, "[text, text]");
  if (array == nullptr) return;
  for (std::size_t i = 0; i < 2; ++i) read(*array->get(i), child(path, i), rule, value[i]);
}

}  // namespace repose
