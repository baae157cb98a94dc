#include "deck/validation_deck.h"

#include "deck/deck_kind.h"
#include "deck/key.h"
#include "deck/key_reference.h"
#include "deck/plain_name.h"
#include "deck/read_described.h"

namespace repose {

template <class V>
void describe(V& v, ComparisonDeck& c) {
  v("figure", c.figure, Unit::none, any_value, required, "key of summary.json");
  v("laboratory", c.laboratory, Unit::none, any_value, required, "measured value, in the unit of the figure");
  v("deviation", c.deviation, Unit::none, at_least(0), optional, "its standard deviation");
  v("published", c.published, Unit::none, any_value, optional, "another simulation's value");
}

template <class V>
void describe(V& v, ValidationCaseDeck& c) {
  v("name", c.name, Unit::none, any_value, required, "name of the case and of its folder, used once");
  v("deck", c.deck, Unit::none, any_value, required, "deck to run, relative to this file");
  v("set", c.set, Unit::none, any_value, optional, "keys of the deck to replace, as with --set");
  v.sections("compare", c.comparisons, required, "a figure to compare");
}

template <class V>
void describe(V& v, ValidationDeck& d) {
  v("title", d.title, Unit::none, any_value, optional, "free text");
  v("published", d.published, Unit::none, any_value, optional, "whose the published values are");
  v.sections("case", d.cases, required, "a run and its comparisons");
}

namespace {

void check(const ValidationDeck& deck, DeckErrors& errors) {
  for (std::size_t i = 0; i < deck.cases.size(); ++i) {
    const std::string& name = deck.cases[i].name;
    const std::string key = fmt::format("case.{}.name", i);
    check_plain_name(name, key, errors);
    for (std::size_t j = 0; j < i; ++j) {
      if (deck.cases[j].name == name) errors.add(key, fmt::format("\"{}\" is the name of another case, too", name));
    }
  }
}

}  // namespace

std::string validation_keys() { return key_reference<ValidationDeck>("Keys of a file for repose validate."); }

ValidationDeck read_validation_deck(const std::string& text, const std::string& path) {
  require_study(text, path, "validate");
  return read_described<ValidationDeck>(text, path, {}, check);
}

}  // namespace repose
