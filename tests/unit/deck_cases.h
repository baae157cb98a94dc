#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "deck/read_deck.h"
#include "deck_error.h"
#include "deck_example.h"

namespace repose::test {

using Overrides = std::vector<std::string>;

inline std::string message_of(const std::string& text, const Overrides& overrides = {}) {
  return deck_error([&] { read_deck(text, "deck.toml", overrides); });
}

/// What is wrong with the example deck after `overrides`, behind its place.
struct Case {
  Overrides overrides;
  const char* message;
};

inline void expect_messages(const std::vector<Case>& cases, const std::string& deck = example_deck) {
  for (const Case& c : cases) {
    const std::string message = message_of(deck, c.overrides);
    EXPECT_TRUE(message.ends_with(c.message)) << message << "\ninstead of\n" << c.message;
  }
}

/// All of several lists.
template <class... More>
Overrides all(Overrides first, const More&... more) {
  (first.insert(first.end(), more.begin(), more.end()), ...);
  return first;
}

inline const char* const fine = "no error";

/// Nothing moves in the second phase.
inline const Overrides still = {"phase.flow.mechanics=false", "heat.every=1",
                                "material.0.conductivity=2",  "material.0.specific_heat=800",
                                "material.1.conductivity=2",  "material.1.specific_heat=800"};

}  // namespace repose::test
