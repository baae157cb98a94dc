#pragma once

#include <set>
#include <string>
#include <string_view>

#include "deck/value_text.h"
#include "import/place.h"

namespace repose {

/// The text of a deck as it grows; each section names the line of the script that it comes from.
class DeckText {
 public:
  void comment(const std::string& line) { text_ += "# " + line + "\n"; }
  void section(const std::string& head, const Place& place) {
    text_ += "\n" + head + "  # " + repose::text(place) + "\n";
  }
  void section(const std::string& head) { text_ += "\n" + head + "\n"; }
  /// A vector, without zeros below zero.
  void key(std::string_view name, const Vec3& value) {
    text_ += std::string(name) + " = " + toml_text(value + Vec3{}) + "\n";
  }
  template <class T>
  void key(std::string_view name, const T& value) {
    text_ += std::string(name) + " = " + toml_text(value) + "\n";
  }
  template <class T>
  void key(std::string_view name, const T& value, const std::string& remark) {
    text_ += std::string(name) + " = " + toml_text(value) + "  # " + remark + "\n";
  }
  void key(std::string_view name, const char* value) { key(name, std::string(value)); }
  void blank() { text_ += "\n"; }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// Names that a deck takes, each once.
class DeckNames {
 public:
  /// A letter, then letters, digits, _ and -, as near to `wanted` as may be.
  std::string take(const std::string& wanted);

 private:
  std::set<std::string> taken_;
};

}  // namespace repose
