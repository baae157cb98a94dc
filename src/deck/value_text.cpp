#include "deck/value_text.h"

#include <cmath>

#include <fmt/core.h>

namespace repose {

std::string range_text(const Range& r) {
  const bool has_min = std::isfinite(r.min);
  const bool has_max = std::isfinite(r.max);
  if (has_min && has_max) {
    return fmt::format("{} {} x {} {}", r.min, r.excludes_min ? "<" : "<=", r.excludes_max ? "<" : "<=", r.max);
  }
  if (has_min) return fmt::format("{} {}", r.excludes_min ? ">" : ">=", r.min);
  if (has_max) return fmt::format("{} {}", r.excludes_max ? "<" : "<=", r.max);
  return {};
}

std::string toml_text(double value) {
  std::string text = fmt::format("{}", value);
  if (text.find_first_of(".en") == std::string::npos) text += ".0";  // -0 would be read as an integer and lose its sign
  return text;
}

std::string toml_text(bool value) { return value ? "true" : "false"; }
std::string toml_text(std::int64_t value) { return fmt::format("{}", value); }
std::string toml_text(std::uint64_t value) { return fmt::format("{}", value); }

std::string toml_text(const std::string& value) {
  std::string text = "\"";
  for (const char c : value) {
    if (c == '"' || c == '\\') {
      text += fmt::format("\\{}", c);
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) {
      text += fmt::format("\\u{:04X}", static_cast<unsigned char>(c));
    } else {
      text += c;
    }
  }
  return text + "\"";
}

std::string toml_text(const Vec3& v) { return toml_list(std::array<double, 3>{v.x, v.y, v.z}); }

}  // namespace repose
