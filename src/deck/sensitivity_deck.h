#pragma once

#include <string>
#include <vector>

#include "deck/study_deck.h"

namespace repose {

struct MorrisDeck {
  bool enabled = false;           ///< true when the deck has the section
  std::int64_t trajectories = 0;  ///< walks through the grid, each of one step per parameter
  std::int64_t levels = 4;        ///< values of each parameter in the grid; even
};

/// What figures do when parameters change.
struct SensitivityDeck {
  StudyDeck study;                   ///< each parameter from `min` to `max`, the others as in the base deck
  std::vector<std::string> figures;  ///< keys of summary.json
  MorrisDeck morris;
};

/// All its keys, for a person.
std::string sensitivity_keys();

/// Reads and checks it. DeckError, with the place, on the first mistake.
SensitivityDeck read_sensitivity_deck(const std::string& text, const std::string& path);

}  // namespace repose
