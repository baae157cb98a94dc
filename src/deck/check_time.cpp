#include <fmt/core.h>

#include "deck/check_deck.h"

namespace repose {
namespace {

/// That a share belongs to the contact law, or has its default. A share of 1 sets no limit, whatever the law: a deck
/// may have all three of them.
void check_share(const char* key, double value, double usual, bool is_used, const char* laws, const char* instead,
                 DeckErrors& errors) {
  if (is_used || value == usual || value == 1.0) return;
  errors.add(fmt::format("time.{}", key),
             fmt::format("\"{}\" belongs to contact.normal_law = {}; give {}, or remove this", key, laws, instead));
}

}  // namespace

void check_time(const Deck& deck, DeckErrors& errors) {
  constexpr const char* elastic = "\"hertz\" or \"jkr\"";
  const TimeDeck usual;
  const bool is_hooke = deck.contact.normal_law == NormalLaw::hooke;
  check_share("rayleigh_fraction", deck.time.rayleigh_fraction, usual.rayleigh_fraction, !is_hooke, elastic,
              "\"hooke_fraction\"", errors);
  check_share("hertz_fraction", deck.time.hertz_fraction, usual.hertz_fraction, !is_hooke, elastic,
              "\"hooke_fraction\"", errors);
  check_share("hooke_fraction", deck.time.hooke_fraction, usual.hooke_fraction, is_hooke, "\"hooke\"",
              "\"rayleigh_fraction\" and \"hertz_fraction\"", errors);
}

}  // namespace repose
