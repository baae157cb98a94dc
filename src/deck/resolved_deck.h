#pragma once

#include <string>

#include "deck/deck.h"

namespace repose {

/// The deck as TOML with every key that applies, in SI, defaults written out; read_deck gives back an equal deck. Keys
/// whose default only the scene can tell (such as time.step) are left out unless they were given.
std::string resolved_deck(const Deck& deck);

/// All keys of a deck, as `repose keys` prints them.
std::string deck_keys();

}  // namespace repose
