#pragma once

#include <string>

#include "deck/deck.h"
#include "scene/insertion/insertion.h"

namespace repose {

/// What a run of this deck would be: particles, time step and what sets it, steps, expected memory and time on `ranks`
/// ranks; as lines for a person. Sets the scene up but runs nothing. DeckError as a run would.
std::string check_report(const Deck& deck, const ReadFile& read_file, int ranks);

}  // namespace repose
