#pragma once

#include "deck/key.h"
#include "deck/study_deck.h"

namespace repose {

constexpr auto enumerators(ParameterPrior) { return std::array<std::string_view, 3>{"uniform", "normal", "lognormal"}; }

template <class V>
void describe(V& v, ParameterDeck& p) {
  v("name", p.name, Unit::none, any_value, required, "name in tables and folders, used once");
  v("key", p.key, Unit::none, any_value, required, "key of the base deck, as with --set");
  v("min", p.min, Unit::none, any_value, optional_else("the least of values"), "lower end, in the key's SI unit");
  v("max", p.max, Unit::none, any_value, optional_else("the greatest of values"), "upper end");
  v("points", p.points, Unit::none, at_least(2), optional_else("none; this or values"),
    "values from min to max, evenly");
  v("values", p.values, Unit::none, any_value, optional_else("none; this or points"), "the values themselves");
  v("fixed", p.fixed, Unit::none, any_value, optional_else("none; sensitivity decks need it"),
    "sensitivity: value while another parameter changes");
  v("prior", p.prior, Unit::none, any_value, optional, "calibration: what is known of it before any run");
  v("prior_mean", p.prior_mean, Unit::none, any_value, optional_else("none; normal and lognormal need it"),
    "calibration: mean of that prior");
  v("prior_deviation", p.prior_deviation, Unit::none, above(0), optional_else("none; normal and lognormal need it"),
    "calibration: its standard deviation");
}

template <class V>
void describe_study(V& v, StudyDeck& s, const Presence& base = required) {
  v("title", s.title, Unit::none, any_value, optional, "free text");
  v("base", s.base, Unit::none, any_value, base, "deck to run, relative to this file");
  v("set", s.set, Unit::none, any_value, optional, "keys of the base deck to replace in all runs, as with --set");
  v("seeds", s.seeds, Unit::none, at_least(1), optional, "runs at each point, with successive seeds");
  v("first_seed", s.first_seed, Unit::none, from_to(0, 1e15), optional, "run.seed of the first of them");
  v("ranks_per_run", s.ranks_per_run, Unit::none, at_least(1), optional, "ranks that work on one run");
  v.sections("parameter", s.parameters, required, "what runs differ in");
}

}  // namespace repose
