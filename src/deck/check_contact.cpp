#include <cmath>

#include <fmt/format.h>

#include "deck/check_deck.h"

namespace repose {
namespace {

/// Without attraction the dashpot grows as 1 / sqrt(restitution), and with it the step that an impact needs.
constexpr double least_restitution_without_attraction = 0.05;

void check_stiffness(const std::string& section, const PairDeck& pair, bool is_hooke, DeckErrors& errors) {
  const bool is_given = !std::isnan(pair.hooke_stiffness);
  if (is_hooke && !is_given) {
    errors.add(section, "[[pair]] lacks \"hooke_stiffness\", which contact.normal_law = \"hooke\" needs");
  }
  if (!is_hooke && is_given) {
    errors.add(section + ".hooke_stiffness",
               "\"hooke_stiffness\" belongs to contact.normal_law = \"hooke\"; set that, or remove this");
  }
}

}  // namespace

void check_contact(const Deck& deck, DeckErrors& errors) {
  for (std::size_t i = 0; i < deck.pairs.size(); ++i) {
    const std::string section = fmt::format("pair.{}", i);
    const PairDeck& pair = deck.pairs[i];
    check_stiffness(section, pair, deck.contact.normal_law == NormalLaw::hooke, errors);
    if (!deck.contact.attraction && pair.restitution < least_restitution_without_attraction) {
      errors.add(section + ".restitution",
                 fmt::format("\"restitution\" = {} is less than {}, the least with contact.attraction = false",
                             pair.restitution, least_restitution_without_attraction));
    }
  }
}

}  // namespace repose
