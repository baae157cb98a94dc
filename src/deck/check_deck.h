#pragma once

#include "deck/deck.h"
#include "deck/deck_errors.h"

namespace repose {

/// Notes what is wrong between the keys of a deck whose single keys are right: names used twice or unknown, missing
/// pairs, impossible shapes, phases that add or remove walls out of order.
void check_deck(const Deck& deck, DeckErrors& errors);

/// The shapes of the walls only (a part of check_deck).
void check_wall_shapes(const Deck& deck, DeckErrors& errors);

/// What the contact law needs of the pairs (a part of check_deck).
void check_contact(const Deck& deck, DeckErrors& errors);

/// Conditions of the phases and the order in which they add and remove walls (a part of check_deck).
void check_phases(const Deck& deck, DeckErrors& errors);

}  // namespace repose
