#pragma once

#include <string>
#include <vector>

#include "deck/deck.h"

namespace repose {

/// A measured figure beside what others have found for it.
struct ComparisonDeck {
  std::string figure;         ///< its key in summary.json, as "scattering.area_1.count"
  double laboratory = unset;  ///< in the unit of the figure
  double deviation = unset;   ///< standard deviation of the laboratory's value
  double published = unset;   ///< what another simulation found
};

/// One run of a deck.
struct ValidationCaseDeck {
  std::string name;              ///< also of its folder
  std::string deck;              ///< path relative to this file
  std::vector<std::string> set;  ///< "key=value" as with --set
  std::vector<ComparisonDeck> comparisons;
};

/// Runs whose figures are compared with those of a laboratory.
struct ValidationDeck {
  std::string title;
  std::string published;  ///< whose figures `published` are, for the head of the table
  std::vector<ValidationCaseDeck> cases;
};

/// All its keys, for a person.
std::string validation_keys();

/// Reads it. DeckError, with the place, on the first mistake.
ValidationDeck read_validation_deck(const std::string& text, const std::string& path);

}  // namespace repose
