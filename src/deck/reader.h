#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/core.h>
#include <toml++/toml.h>

#include "deck/deck_errors.h"
#include "deck/value_text.h"

namespace repose {

/// "particles.sizes" for "particles.0.sizes": a section as the deck writes it.
std::string without_indices(std::string_view path);

/// Where the command line replaced something: full key -> text of --set.
using Overridden = std::map<std::string, std::string>;

/// The visitor that fills a deck from a parsed file and notes every error with its place: unknown, missing and
/// misplaced keys, wrong types, units, ranges and lengths. What connects several keys is left to check_deck.
class Reader {
 public:
  Reader(const toml::table& root, const Overridden& overridden, DeckErrors& errors);

  template <class T>
  void operator()(std::string_view key, T& value, Unit unit, const Range& range, const Presence& presence,
                  std::string_view meaning) {
    const toml::node* node = find(key, presence, meaning);
    const std::size_t errors_before = errors_.count();
    if (node != nullptr) read(*node, child(levels_.back().path, key), {unit, range}, value);
    // Without its type it is open which other keys a section may have.
    const bool has_failed =
        node == nullptr ? presence.is_required && presence.applies : errors_.count() > errors_before;
    if (std::is_enum_v<T> && has_failed) levels_.back().type_is_unknown = true;
  }

  template <class S>
  void section(std::string_view name, S& value, const Presence& presence, std::string_view meaning) {
    const toml::node* node = find(name, presence, meaning);
    if (node == nullptr) return;
    if constexpr (requires { value.enabled; }) value.enabled = true;
    const std::string path = child(levels_.back().path, name);
    if (enter(*node, path, "[" + without_indices(path) + "]")) {
      describe(*this, value);
      leave();
    }
  }

  template <class S>
  void sections(std::string_view name, std::vector<S>& values, const Presence& presence, std::string_view meaning) {
    const toml::array* array = find_sections(name, presence, meaning);
    if (array == nullptr) return;
    const std::string path = child(levels_.back().path, name);
    values.resize(array->size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!enter(*array->get(i), child(path, i), "[[" + path + "]]")) continue;
      describe(*this, values[i]);
      leave();
    }
  }

  template <class F>
  void group(std::string_view name, F&& visit) {
    const toml::node* node = find(name, optional, "");
    if (node == nullptr) return;
    const std::string path = child(levels_.back().path, name);
    if (enter(*node, path, "[" + path + "]")) {
      visit(*this);
      leave();
    }
  }

  /// Notes the unknown and missing keys of the top level; call after the visit.
  void finish() { leave(); }

 private:
  struct Level {
    const toml::table* table;
    std::string path;
    std::string title;
    std::size_t errors_before;
    std::vector<std::string> known;
    std::vector<std::string> missing;
    bool type_is_unknown = false;
  };
  struct Rule {
    Unit unit;
    const Range& range;
  };

  const toml::node* find(std::string_view key, const Presence& presence, std::string_view meaning);
  const toml::array* find_sections(std::string_view name, const Presence& presence, std::string_view meaning);
  bool enter(const toml::node& node, const std::string& path, const std::string& title);
  void leave();
  KeyPlace locate(const std::string& path, const toml::source_region& source);
  void refuse(const std::string& path, const toml::node& node, std::string_view wanted);
  const toml::array* list(const toml::node& node, const std::string& path, std::size_t length, std::string_view wanted);
  bool in_range(double value, const std::string& path, const Rule& rule);
  bool read_choice(const toml::node& node, const std::string& path, const std::vector<std::string>& names,
                   std::size_t& choice);

  void read(const toml::node& node, const std::string& path, const Rule& rule, double& value);
  void read(const toml::node& node, const std::string& path, const Rule& rule, std::int64_t& value);
  void read(const toml::node& node, const std::string& path, const Rule& rule, std::uint64_t& value);
  void read(const toml::node& node, const std::string& path, const Rule& rule, bool& value);
  void read(const toml::node& node, const std::string& path, const Rule& rule, std::string& value);
  void read(const toml::node& node, const std::string& path, const Rule& rule, Vec3& value);
  void read(const toml::node& node, const std::string& path, const Rule& rule, std::array<double, 2>& value);
  void read(const toml::node& node, const std::string& path, const Rule& rule, std::array<std::string, 2>& value);

  template <class T>
  void read(const toml::node& node, const std::string& path, const Rule& rule, std::vector<T>& values) {
    const toml::array* array = list(node, path, any_length, kind_text(values));
    if (array == nullptr) return;
    values.resize(array->size());
    for (std::size_t i = 0; i < values.size(); ++i) read(*array->get(i), child(path, i), rule, values[i]);
  }

  template <class E>
  requires std::is_enum_v<E>
  void read(const toml::node& node, const std::string& path, const Rule&, E& value) {
    constexpr auto names = enumerators(E{});
    std::size_t choice = 0;
    if (read_choice(node, path, {names.begin(), names.end()}, choice)) value = static_cast<E>(choice);
  }

  static constexpr std::size_t any_length = static_cast<std::size_t>(-1);

  const Overridden& overridden_;
  DeckErrors& errors_;
  std::vector<Level> levels_;
};

}  // namespace repose
