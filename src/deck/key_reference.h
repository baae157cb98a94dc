#pragma once

#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/ranges.h>

#include "deck/value_text.h"

namespace repose {

/// The visitor (deck/key.h) that collects, section by section, a row for each key.
class KeyReference {
 public:
  template <class T>
  void operator()(std::string_view key, T& value, Unit unit, const Range& range, const Presence& presence,
                  std::string_view meaning) {
    const std::string condition = presence.condition.empty() ? std::string() : fmt::format(" ({})", presence.condition);
    groups_.back().rows.push_back({std::string(key), std::string(symbol(unit)), kind_text(value),
                                   allowed_text(value, range), default_text(value, presence),
                                   std::string(meaning) + condition});
  }

  template <class S>
  void section(std::string_view name, S& value, const Presence& presence, std::string_view meaning) {
    begin(fmt::format("[{}{}]", group_, name), presence, meaning);
    describe_inside(name, value);
  }

  template <class S>
  void sections(std::string_view name, std::vector<S>&, const Presence& presence, std::string_view meaning) {
    begin(fmt::format("[[{}{}]]", group_, name), presence, meaning);
    S one;
    describe_inside(name, one);
  }

  template <class F>
  void group(std::string_view name, F&& visit) {
    group_ = fmt::format("{}.", name);
    visit(*this);
    group_.clear();
  }

  /// A table for a person, below this line.
  std::string text(std::string_view title) const;

 private:
  using Row = std::array<std::string, 6>;
  struct Group {
    std::string heading;
    std::vector<Row> rows;
  };

  template <class T>
  static std::string allowed_text(const T&, const Range& range) {
    if constexpr (std::is_enum_v<T>) return fmt::format("{}", fmt::join(enumerators(T{}), "|"));
    return range_text(range);
  }
  template <class E>
  requires std::is_enum_v<E>
  static std::string allowed_text(const std::vector<E>&, const Range& range) { return allowed_text(E{}, range); }

  template <class T>
  static std::string default_text(const T& value, const Presence& presence) {
    if (presence.is_required) return "required";
    if (!presence.fallback.empty()) return std::string(presence.fallback);
    return is_unset(value) ? "none" : toml_text(value);
  }
  template <class T>
  static bool is_unset(const T&) {
    return false;
  }
  static bool is_unset(double value) { return std::isnan(value); }
  static bool is_unset(const std::array<double, 2>& place) { return std::isnan(place[0]); }

  template <class S>
  void describe_inside(std::string_view name, S& value) {
    const std::string outer = std::exchange(group_, fmt::format("{}{}.", group_, name));
    describe(*this, value);
    group_ = outer;
  }
  void begin(const std::string& title, const Presence& presence, std::string_view meaning);

  std::vector<Group> groups_{{"(top level)", {}}};
  std::string group_;
};

/// All keys that describe(visitor, D&) names, by section with unit, type, range, default and meaning. `title`: a line
/// above them, which says of what file.
template <class D>
std::string key_reference(std::string_view title) {
  D defaults;
  KeyReference reference;
  describe(reference, defaults);
  return reference.text(title);
}

}  // namespace repose
