#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/vec3.h"
#include "deck/key.h"

/// Values of the schema as text, one overload per type of member.
namespace repose {

/// As TOML. Numbers are the shortest that read back to the same double.
std::string toml_text(double value);
std::string toml_text(bool value);
std::string toml_text(std::int64_t value);
std::string toml_text(std::uint64_t value);
std::string toml_text(const std::string& value);
std::string toml_text(const Vec3& value);

/// What kind of value a member takes, for people: "number", "[x, y, z]", ...
inline std::string kind_text(double) { return "number"; }
inline std::string kind_text(bool) { return "true/false"; }
inline std::string kind_text(std::int64_t) { return "integer"; }
inline std::string kind_text(std::uint64_t) { return "integer"; }
inline std::string kind_text(const std::string&) { return "text"; }
inline std::string kind_text(const Vec3&) { return "[x, y, z]"; }
inline std::string kind_text(const std::array<std::string, 2>&) { return "[text, text]"; }
inline std::string kind_text(const std::array<double, 2>&) { return "[x, y]"; }
inline std::string kind_text(const std::vector<double>&) { return "list of numbers"; }
inline std::string kind_text(const std::vector<std::int64_t>&) { return "list of integers"; }
inline std::string kind_text(const std::vector<std::string>&) { return "list of texts"; }
inline std::string kind_text(const std::vector<std::array<double, 2>>&) { return "list of [r, z]"; }

template <class E>
requires std::is_enum_v<E> std::string kind_text(E) { return "choice"; }
template <class E>
requires std::is_enum_v<E> std::string kind_text(const std::vector<E>&) { return "list of choices"; }

template <class E>
requires std::is_enum_v<E> std::string toml_text(E value) {
  return toml_text(std::string(enumerators(E{}).at(static_cast<std::size_t>(value))));
}

template <class T, std::size_t n>
std::string toml_text(const std::array<T, n>& values);
template <class T>
std::string toml_text(const std::vector<T>& values);

template <class List>
std::string toml_list(const List& values) {
  std::string text = "[";
  for (const auto& value : values) {
    if (text.size() > 1) text += ", ";
    text += toml_text(value);
  }
  text += "]";
  return text;
}

template <class T, std::size_t n>
std::string toml_text(const std::array<T, n>& values) {
  return toml_list(values);
}

template <class T>
std::string toml_text(const std::vector<T>& values) {
  return toml_list(values);
}

/// False for an optional number that holds its "not given" value: NaN, or a count outside its range.
template <class T>
bool is_given(const T& value, const Range& range) {
  if constexpr (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) return range.contains(static_cast<double>(value));
  return true;
}

/// Element 0, 1, ... of a list keeps its place under "key.0", "key.1", ...
inline std::string child(std::string_view parent, std::string_view key) {
  return parent.empty() ? std::string(key) : std::string(parent) + "." + std::string(key);
}
inline std::string child(std::string_view parent, std::size_t index) { return child(parent, std::to_string(index)); }

}  // namespace repose
