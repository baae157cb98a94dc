#pragma once

#include <vector>

#include "deck/deck.h"

namespace repose::test {

/// `deck` with Hooke's law; its stiffness is that of Hertz at an overlap of a few per cent of 0.5 mm.
inline Deck with_hooke(Deck deck) {
  deck.contact.normal_law = NormalLaw::hooke;
  for (PairDeck& pair : deck.pairs) pair.hooke_stiffness = 400.0;
  deck.time.hooke_fraction = 0.1;
  return deck;
}

/// `deck` with every combination of the options of [contact] and time.integrator; the first has the defaults.
inline std::vector<Deck> decks_of_all_options(const Deck& deck) {
  std::vector<Deck> decks;
  for (int k = 0; k < 32; ++k) {
    Deck d = (k & 1) != 0 ? with_hooke(deck) : deck;
    d.contact.attraction = (k & 2) == 0;
    d.contact.tangential_spring = (k & 4) != 0 ? TangentialSpring::rotated : TangentialSpring::projected;
    d.contact.rolling_history = (k & 8) != 0 ? RollingHistory::rotated : RollingHistory::fixed;
    d.time.integrator = (k & 16) != 0 ? Integrator::synchronised_verlet : Integrator::velocity_verlet;
    decks.push_back(d);
  }
  return decks;
}

/// `deck` with none of the defaults.
inline Deck with_all_options(const Deck& deck) { return decks_of_all_options(deck).back(); }

}  // namespace repose::test
