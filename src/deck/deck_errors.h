#pragma once

#include <map>
#include <string>
#include <vector>

namespace repose {

/// Where a key stands: in the deck, or in an override of the command line (then line and column are 0).
struct KeyPlace {
  int line = 1;
  int column = 1;
  std::string set_text;  ///< "time.step=2e-6" of --set
};

/// Gathers what is wrong with a deck and throws the first of it by position. Keys are named by their full path, such as
/// "material.0.density"; list elements by their index.
class DeckErrors {
 public:
  explicit DeckErrors(std::string file) : file_(std::move(file)) {}

  void locate(const std::string& key, KeyPlace place) { places_[key] = std::move(place); }
  /// At the place of `key`, or of the innermost section around it that has one.
  void add(const std::string& key, const std::string& message);
  void add(const KeyPlace& place, const std::string& message) { errors_.push_back({place, message}); }
  std::size_t count() const { return errors_.size(); }
  /// Throws DeckError "path:line:column: message" or "--set key=value: message"; overrides come first.
  void throw_first() const;

 private:
  struct Entry {
    KeyPlace place;
    std::string message;
  };

  std::string file_;
  std::map<std::string, KeyPlace> places_;
  std::vector<Entry> errors_;
};

}  // namespace repose
