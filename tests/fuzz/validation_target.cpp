// Cases to run and values to compare with.
#include <cmath>

#include "deck/validation_deck.h"
#include "target.h"

namespace repose::fuzz {

bool accepts(std::string_view input) {
  ValidationDeck deck;
  if (!is_done([&] { deck = read_validation_deck(std::string(input), "validation.toml"); })) return false;
  for (const ValidationCaseDeck& one : deck.cases) {
    expect(one.name.find('/') == std::string::npos && one.name.find('.') == std::string::npos, "a name is no path");
    for (const ComparisonDeck& c : one.comparisons)
      expect(!std::isnan(c.laboratory), "there is a value to compare with");
  }
  return true;
}

}  // namespace repose::fuzz
