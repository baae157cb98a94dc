#pragma once

#include <array>
#include <limits>
#include <string>
#include <string_view>

#include "deck/units.h"

/// What is said of a key beside its name, its member and its meaning. describe(visitor, section) names the keys of a
/// section; the reader, the writer and `repose keys` are visitors. A visitor has
///   operator()(name, member, Unit, Range, Presence, meaning)    one key
///   section(name, struct, Presence, meaning)                    [name]
///   sections(name, vector of structs, Presence, meaning)        [[name]], at least one when required
///   group(name, function of the visitor)                        sections below [name.
namespace repose {

inline constexpr double unset = std::numeric_limits<double>::quiet_NaN();  ///< an optional number that was not given

/// The values a number may take; of each component of a vector or a list.
struct Range {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool excludes_min = false;
  bool excludes_max = false;

  /// False for NaN.
  constexpr bool contains(double x) const {
    return (excludes_min ? x > min : x >= min) && (excludes_max ? x < max : x <= max);
  }
};

inline constexpr Range any_value{};
constexpr Range above(double min) { return {.min = min, .excludes_min = true}; }
constexpr Range at_least(double min) { return {.min = min}; }
constexpr Range from_to(double min, double max) { return {.min = min, .max = max}; }
constexpr Range from_to_below(double min, double max) { return {.min = min, .max = max, .excludes_max = true}; }
constexpr Range above_to(double min, double max) { return {.min = min, .max = max, .excludes_min = true}; }

/// As people write it: "> 0", ">= 1", "0 <= x < 0.5"; empty when everything is allowed.
std::string range_text(const Range& range);

/// Whether a key must, may or may not be given.
struct Presence {
  bool is_required = false;
  bool applies = true;              ///< false: the key belongs to another type and is refused
  std::string_view condition = {};  ///< what makes it apply, such as "type = profile"
  std::string_view fallback = {};   ///< the default in words where it is derived from other keys

  constexpr Presence when(bool holds, std::string_view what) const { return {is_required, holds, what, fallback}; }
};

inline constexpr Presence required{.is_required = true};
inline constexpr Presence optional{};
constexpr Presence optional_else(std::string_view fallback) { return {.fallback = fallback}; }

}  // namespace repose
