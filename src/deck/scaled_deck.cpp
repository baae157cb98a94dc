#include "deck/scaled_deck.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "base/error.h"
#include "deck/deck.h"
#include "deck/parse_toml.h"
#include "deck/reader.h"

namespace repose {
namespace {

/// A number, or a text with a unit, where it stands.
struct Found {
  std::string key;  ///< with the place of each [[section]]; those of a list have the same
  Unit unit = Unit::none;
  const toml::node* node = nullptr;
};

/// The visitor that finds the numbers of a deck.
class Finder {
 public:
  explicit Finder(const toml::table& root) : levels_{{&root, ""}} {}

  template <class T>
  void operator()(std::string_view key, T&, Unit unit, const Range&, const Presence&, std::string_view) {
    if (const toml::node* node = levels_.back().table->get(key)) add(*node, child(levels_.back().path, key), unit);
  }

  template <class S>
  void section(std::string_view name, S& value, const Presence&, std::string_view) {
    group(name, [&value](Finder& finder) { describe(finder, value); });
  }

  template <class S>
  void sections(std::string_view name, std::vector<S>&, const Presence&, std::string_view) {
    const toml::node* node = levels_.back().table->get(name);
    if (node == nullptr || !node->is_array()) return;
    std::size_t place = 0;
    for (const toml::node& one : *node->as_array()) {
      S value;
      enter(one, child(child(levels_.back().path, name), place++), [&value](Finder& f) { describe(f, value); });
    }
  }

  template <class F>
  void group(std::string_view name, F&& visit) {
    if (const toml::node* node = levels_.back().table->get(name)) {
      enter(*node, child(levels_.back().path, name), std::forward<F>(visit));
    }
  }

  const std::vector<Found>& found() const { return found_; }

 private:
  struct Level {
    const toml::table* table;
    std::string path;
  };

  template <class F>
  void enter(const toml::node& node, const std::string& path, F&& visit) {
    if (!node.is_table()) return;
    levels_.push_back({node.as_table(), path});
    visit(*this);
    levels_.pop_back();
  }

  void add(const toml::node& node, const std::string& key, Unit unit) {
    if (const toml::array* array = node.as_array()) {
      for (const toml::node& one : *array) add(one, key, unit);
    } else if (node.is_number() || (unit != Unit::none && node.is_string())) {
      found_.push_back({key, unit, &node});
    }
  }

  std::vector<Level> levels_;
  std::vector<Found> found_;
};

/// Whether what the key gives is as large as the grains, whatever the apparatus is.
bool is_of_grains(const std::string& key) {
  static const std::vector<std::string> keys = {"particles.diameter",
                                                "particles.spacing",
                                                "particles.sizes.diameters",
                                                "particles.sizes.median",
                                                "particles.sizes.scale",
                                                "particles.sizes.min_diameter",
                                                "particles.sizes.max_diameter",
                                                "phase.kinetic_energy",
                                                "measurement.tilt_onset.displacement",
                                                "measurement.scattering.ring_width",
                                                "measurement.bulk_density.surface_gap"};
  return std::find(keys.begin(), keys.end(), without_indices(key)) != keys.end();
}

/// By what a number of this unit grows with lengths, and with times as their root. The units of heat do not occur where
/// nothing but gravity and inertia sets the scale: they stay.
double factor_of(Unit unit, double length, double density) {
  const double root = std::sqrt(length);
  switch (unit) {
    case Unit::metre:
      return length;
    case Unit::area:
      return length * length;
    case Unit::volume:
      return length * length * length;
    case Unit::second:
    case Unit::speed:
      return root;
    case Unit::per_second:
    case Unit::hertz:
    case Unit::angular_speed:
      return 1.0 / root;
    case Unit::kilogram:
    case Unit::newton:
      return density * length * length * length;
    case Unit::mass_rate:
      return density * length * length * root;
    case Unit::stiffness:
      return density * length * length;
    case Unit::pascal:
      return density * length;
    case Unit::joule:
    case Unit::newton_metre:
      return density * length * length * length * length;
    case Unit::none:
    case Unit::density:
    case Unit::acceleration:
    case Unit::kelvin:
    case Unit::watt:
    case Unit::conductance:
    case Unit::specific_power:
    case Unit::ohm:
    case Unit::conductivity:
    case Unit::specific_heat:
    case Unit::volumetric_heat:
    case Unit::diffusivity:
    case Unit::per_kelvin:
    case Unit::heating_rate:
      return 1.0;
  }
  return 1.0;
}

/// A number of the deck, times `factor`, as it is written there: with its unit, or bare.
std::string scaled(std::string_view token, double factor) {
  const bool is_text = token.front() == '"' || token.front() == '\'';
  const std::string_view inside = is_text ? token.substr(1, token.size() - 2) : token;
  double value = 0.0;
  const auto read = std::from_chars(inside.data(), inside.data() + inside.size(), value);
  if (read.ec != std::errc() || value == 0.0 || factor == 1.0) return std::string(token);
  const std::string number = fmt::format("{:.6g}", value * factor);
  if (is_text) return fmt::format("\"{}{}\"", number, std::string_view(read.ptr, inside.data() + inside.size()));
  return number.find_first_of(".e") == std::string::npos ? number + ".0" : number;
}

std::string scaled_count(std::string_view token, double factor) {
  double value = 0.0;
  std::from_chars(token.data(), token.data() + token.size(), value);
  return fmt::format("{:.0f}", std::max(1.0, std::round(value * factor)));
}

/// What stands for a value in the text, from its first character on.
std::string_view token_at(std::string_view text, std::size_t begin) {
  const char quote = text[begin];
  if (quote == '"' || quote == '\'') return text.substr(begin, text.find(quote, begin + 1) + 1 - begin);
  return text.substr(begin, text.find_first_of(" \t\n\r,]#", begin) - begin);
}

/// Where each line of the text begins.
std::vector<std::size_t> line_beginnings(std::string_view text) {
  std::vector<std::size_t> beginnings = {0};
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\n') beginnings.push_back(i + 1);
  }
  return beginnings;
}

struct Replacement {
  std::size_t begin = 0;
  std::size_t length = 0;
  std::string by;
};

Replacement replacement(const std::string& text, std::size_t begin, const Found& found, const DeckScale& scale) {
  const std::string_view token = token_at(text, begin);
  if (const auto given = scale.given.find(found.key); given != scale.given.end()) {
    return {begin, text.find('\n', begin) - begin, toml_text(given->second)};  // and no comment
  }
  const double per_length = scale.lengths / scale.grains;
  if (without_indices(found.key) == "particles.count") {
    return {begin, token.size(), scaled_count(token, per_length * per_length * per_length)};
  }
  const double length = is_of_grains(found.key) ? scale.grains : scale.lengths;
  return {begin, token.size(), scaled(token, factor_of(found.unit, length, scale.density))};
}

}  // namespace

std::string scaled_deck(const std::string& text, const std::string& path, const DeckScale& scale) {
  const toml::table root = parse_toml(text, path);
  Finder finder(root);
  Deck deck;
  describe(finder, deck);
  for (const auto& entry : scale.given) {
    const std::string& key = entry.first;  // clang 14 captures no part of a binding
    const auto has_key = [&key](const Found& found) { return found.key == key; };
    if (std::none_of(finder.found().begin(), finder.found().end(), has_key)) {
      throw DeckError(fmt::format("{}: has no number \"{}\" that could be replaced", path, key));
    }
  }
  const std::vector<std::size_t> lines = line_beginnings(text);
  std::vector<Replacement> replacements;
  for (const Found& found : finder.found()) {
    const toml::source_position place = found.node->source().begin;
    replacements.push_back(replacement(text, lines[place.line - 1] + place.column - 1, found, scale));
  }
  std::sort(replacements.begin(), replacements.end(),
            [](const Replacement& a, const Replacement& b) { return a.begin > b.begin; });
  std::string result = text;
  for (const Replacement& one : replacements) result.replace(one.begin, one.length, one.by);
  return result;
}

}  // namespace repose
