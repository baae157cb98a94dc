#pragma once

#include <algorithm>
#include <string>

#include "deck/deck.h"

namespace repose {

/// Whether the deck has a [[pair]] of two materials, in either order.
inline bool has_pair(const Deck& deck, const std::string& a, const std::string& b) {
  return std::any_of(deck.pairs.begin(), deck.pairs.end(), [&](const PairDeck& p) {
    return (p.materials[0] == a && p.materials[1] == b) || (p.materials[0] == b && p.materials[1] == a);
  });
}

}  // namespace repose
