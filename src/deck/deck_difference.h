#pragma once

#include <string>
#include <vector>

namespace repose {

/// A key in which two decks differ.
struct DeckDifference {
  std::string key;     ///< as "wall[2].radius"
  std::string before;  ///< TOML value; empty where the deck has none
  std::string now;
};

/// For a person: the value of a key in one of two decks, "nothing" where that deck does not have it.
inline std::string value_or_nothing(const std::string& value) { return value.empty() ? "nothing" : value; }

/// The keys in which two resolved decks (resolved_deck.h) differ, in alphabetical order. DeckError when one is no TOML.
std::vector<DeckDifference> deck_differences(const std::string& before, const std::string& now);

/// The same of a resolved deck with overrides and another one, both as this version reads them, but for keys that both
/// leave at a default which follows from others, such as a spacing from the diameter. DeckError when one is no deck.
std::vector<DeckDifference> deck_differences_beyond(const std::vector<std::string>& overrides,
                                                    const std::string& before, const std::string& now);

}  // namespace repose
