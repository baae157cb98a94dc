#include <algorithm>
#include <array>
#include <utility>

#include <fmt/core.h>

#include "deck/deck.h"
#include "deck/resolved_deck.h"
#include "deck/value_text.h"

namespace repose {
namespace {

using Row = std::array<std::string, 6>;

struct Group {
  std::string heading;
  std::vector<Row> rows;
};

template <class T>
std::string allowed_text(const T&, const Range& range);

template <class E>
requires std::is_enum_v<E> std::string allowed_text(const std::vector<E>&, const Range& range) {
  return allowed_text(E{}, range);
}

template <class T>
std::string allowed_text(const T&, const Range& range) {
  if constexpr (std::is_enum_v<T>) {
    std::string all;
    for (const std::string_view name : enumerators(T{})) {
      if (!all.empty()) all += "|";
      all += name;
    }
    return all;
  }
  return range_text(range);
}

/// The visitor that collects one row per key.
class Documenter {
 public:
  template <class T>
  void operator()(std::string_view key, T& value, Unit unit, const Range& range, const Presence& presence,
                  std::string_view meaning) {
    const std::string fallback = presence.is_required        ? std::string("required")
                                 : presence.fallback.empty() ? toml_text(value)
                                                             : std::string(presence.fallback);
    const std::string condition = presence.condition.empty() ? std::string() : fmt::format(" ({})", presence.condition);
    groups_.back().rows.push_back({std::string(key), std::string(symbol(unit)), kind_text(value),
                                   allowed_text(value, range), fallback, std::string(meaning) + condition});
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

  std::string text() const;

 private:
  template <class S>
  void describe_inside(std::string_view name, S& value) {
    const std::string outer = std::exchange(group_, fmt::format("{}{}.", group_, name));
    describe(*this, value);
    group_ = outer;
  }
  void begin(const std::string& title, const Presence& presence, std::string_view meaning) {
    groups_.push_back({fmt::format("{}  {}{}", title, meaning, presence.is_required ? " (required)" : ""), {}});
  }

  std::vector<Group> groups_{{"(top level)", {}}};
  std::string group_;
};

std::string Documenter::text() const {
  Row titles{"key", "unit", "type", "range", "default", "meaning"};
  std::array<std::size_t, 6> widths{};
  const auto widen = [&](const Row& row) {
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
  };
  const auto line = [&](const Row& row) {
    std::string text = " ";
    for (std::size_t c = 0; c + 1 < row.size(); ++c) text += fmt::format(" {:<{}} ", row[c], widths[c]);
    return text + fmt::format(" {}\n", row.back());
  };
  widen(titles);
  for (const Group& group : groups_) std::for_each(group.rows.begin(), group.rows.end(), widen);

  std::string text = "Keys of a deck. A number is SI; a text such as \"440 um\" carries its unit.\n\n" + line(titles);
  for (const Group& group : groups_) {
    text += fmt::format("\n{}\n", group.heading);
    for (const Row& row : group.rows) text += line(row);
  }
  return text;
}

}  // namespace

std::string key_reference() {
  Deck defaults;
  Documenter documenter;
  describe(documenter, defaults);
  return documenter.text();
}

}  // namespace repose
