#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/vec3.h"

/// State as JSON, for checkpoints. A class that comes to hold more than its constructor gives it names that in one
/// function, for writing and reading alike, by calls of the visitor v(key, member):
///   template <class Self, class Visitor>
///   static void describe_state(Self& self, Visitor& v) { v("steps", self.steps_); }
/// Members are numbers, texts, Vec3, optionals, arrays and vectors of them, and classes that describe their state. Of
/// classes, v.each("flows", self.flows_) keeps the vector and reads the state of each.
namespace repose {

struct AnyVisitor {
  template <class... A>
  void operator()(const char*, A&&...) {}
  template <class... A>
  void each(const char*, A&&...) {}
};
template <class T>
concept HasState = requires(T& t, AnyVisitor& v) {
  T::describe_state(t, v);
};

/// Collects state in a JSON object.
class StateWriter {
 public:
  template <class T>
  void operator()(const char* key, const T& value) {
    json_[key] = encode(value);
  }
  template <HasState T>
  void each(const char* key, const std::vector<T>& values) {
    json_[key] = encode(values);
  }
  const nlohmann::json& json() const { return json_; }

  template <class T>
  static nlohmann::json encode(const T& value) {
    if constexpr (HasState<const T>) {
      StateWriter inner;
      T::describe_state(value, inner);
      return inner.json_;
    } else if constexpr (std::is_same_v<T, double>) {
      return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(fmt::format("{}", value));
    } else {
      return value;  // whole numbers, bool, texts
    }
  }

 private:
  static nlohmann::json encode(const Vec3& v) { return {encode(v.x), encode(v.y), encode(v.z)}; }
  template <class T>
  static nlohmann::json encode(const std::optional<T>& value) {
    return value ? encode(*value) : nlohmann::json(nullptr);
  }
  template <class T>
  static nlohmann::json encode_list(const T& values) {
    nlohmann::json list = nlohmann::json::array();
    for (const auto& value : values) list.push_back(encode(value));
    return list;
  }
  template <class T>
  static nlohmann::json encode(const std::vector<T>& values) {
    return encode_list(values);
  }
  template <class T, std::size_t n>
  static nlohmann::json encode(const std::array<T, n>& values) {
    return encode_list(values);
  }

  nlohmann::json json_ = nlohmann::json::object();
};

/// Gives state back. FileError, which begins with `where`, when the JSON does not fit.
class StateReader {
 public:
  StateReader(const nlohmann::json& json, std::string where) : json_(json), where_(std::move(where)) {}

  bool has(const char* key) const { return json_.is_object() && json_.contains(key); }

  template <class T>
  void operator()(const char* key, T& value) {
    decode(at(key), place(key), value);
  }
  template <HasState T>
  void each(const char* key, std::vector<T>& values) {
    const nlohmann::json& list = at(key);
    expect(list.is_array() && list.size() == values.size(), key, fmt::format("a list of {}", values.size()));
    for (std::size_t i = 0; i < values.size(); ++i) decode(list[i], fmt::format("{}[{}]", place(key), i), values[i]);
  }

 private:
  std::string place(const char* key) const { return fmt::format("{}.{}", where_, key); }
  const nlohmann::json& at(const char* key) const {
    if (!has(key)) fail(place(key), "is missing");
    return json_[key];
  }
  [[noreturn]] static void fail(const std::string& place, const std::string& what) {
    throw FileError(fmt::format("{} {}", place, what));
  }
  void expect(bool holds, const char* key, const std::string& what) const {
    if (!holds) fail(place(key), "is not " + what);
  }

  template <class T>
  static void decode(const nlohmann::json& json, const std::string& place, T& value) {
    if constexpr (HasState<T>) {
      StateReader inner(json, place);
      T::describe_state(value, inner);
    } else if constexpr (std::is_same_v<T, bool>) {
      if (!json.is_boolean()) fail(place, "is not true or false");
      value = json.get<bool>();
    } else if constexpr (std::is_same_v<T, std::string>) {
      if (!json.is_string()) fail(place, "is not a text");
      value = json.get<std::string>();
    } else if constexpr (std::is_same_v<T, double>) {
      decode_double(json, place, value);
    } else {
      static_assert(std::integral<T>);
      if (!json.is_number_integer()) fail(place, "is not a whole number");
      value = json.get<T>();
    }
  }
  static void decode_double(const nlohmann::json& json, const std::string& place, double& value) {
    using Limits = std::numeric_limits<double>;
    if (json == "inf" || json == "-inf") {
      value = json == "inf" ? Limits::infinity() : -Limits::infinity();
    } else if (json == "nan" || json == "-nan") {
      value = Limits::quiet_NaN();
    } else {
      if (!json.is_number()) fail(place, "is not a number");
      value = json.get<double>();
    }
  }
  static void decode(const nlohmann::json& json, const std::string& place, Vec3& v) {
    std::array<double, 3> xyz{};
    decode(json, place, xyz);
    v = {xyz[0], xyz[1], xyz[2]};
  }
  template <class T>
  static void decode(const nlohmann::json& json, const std::string& place, std::optional<T>& value) {
    value.reset();
    if (!json.is_null()) decode(json, place, value.emplace());
  }
  template <class T>
  static void decode(const nlohmann::json& json, const std::string& place, std::vector<T>& values) {
    if (!json.is_array()) fail(place, "is not a list");
    values.assign(json.size(), T{});
    for (std::size_t i = 0; i < values.size(); ++i) decode(json[i], place, values[i]);
  }
  template <class T, std::size_t n>
  static void decode(const nlohmann::json& json, const std::string& place, std::array<T, n>& values) {
    if (!json.is_array() || json.size() != n) fail(place, fmt::format("is not a list of {}", n));
    for (std::size_t i = 0; i < n; ++i) decode(json[i], place, values[i]);
  }

  const nlohmann::json& json_;
  std::string where_;
};

}  // namespace repose
