#include "deck/sensitivity_deck.h"

#include <algorithm>
#include <iterator>
#include <type_traits>

#include <fmt/core.h>

#include "deck/deck_kind.h"
#include "deck/key_reference.h"
#include "deck/read_described.h"
#include "deck/study_schema.h"

namespace repose {

template <class V>
void describe(V& v, MorrisDeck& m) {
  v("trajectories", m.trajectories, Unit::none, at_least(2), required, "walks, each of one step per parameter");
  v("levels", m.levels, Unit::none, at_least(2), optional, "values of each parameter; even");
}

/// A parameter of a study without what a calibration alone has.
struct VariedParameter {
  ParameterDeck deck;
};

/// Hands on the keys of a study, of which a parameter must have its ends and may have nothing of a calibration;
/// `repose keys` does not list that.
template <class V>
struct WithoutCalibration {
  V& v;

  template <class T>
  void operator()(std::string_view key, T& value, Unit unit, const Range& range, const Presence& presence,
                  std::string_view meaning) {
    constexpr std::string_view others[] = {"points", "values", "prior", "prior_mean", "prior_deviation"};
    if (std::find(std::begin(others), std::end(others), key) == std::end(others)) {
      v(key, value, unit, range, key == "min" || key == "max" || key == "fixed" ? required : presence, meaning);
    } else if constexpr (!std::is_same_v<V, KeyReference>) {
      v(key, value, unit, range, presence.when(false, "a calibration"), meaning);
    }
  }
  void sections(std::string_view name, std::vector<ParameterDeck>& parameters, const Presence& presence,
                std::string_view meaning) {
    std::vector<VariedParameter> varied;
    v.sections(name, varied, presence, meaning);
    for (const VariedParameter& p : varied) parameters.push_back(p.deck);
  }
};

template <class V>
void describe(V& v, VariedParameter& p) {
  WithoutCalibration<V> some{v};
  describe(some, p.deck);
}

template <class V>
void describe(V& v, SensitivityDeck& d) {
  v("figures", d.figures, Unit::none, any_value, required, "keys of summary.json");
  WithoutCalibration<V> some{v};
  describe_study(some, d.study);
  v.section("morris", d.morris, optional, "Morris screening beside one at a time");
}

namespace {

void check(SensitivityDeck& deck, DeckErrors& errors) {
  check_study(deck.study, errors);
  check_column_names(deck.study, deck.figures, errors);
  if (deck.figures.empty()) errors.add("figures", "\"figures\" names none");
  constexpr std::int64_t most = 100000;
  if (deck.study.seeds > most || deck.morris.trajectories > most || deck.morris.levels > most) {
    errors.add("seeds", fmt::format("at most {} seeds, trajectories and levels are taken", most));
  }
  if (deck.morris.levels % 2 != 0) errors.add("morris.levels", "\"levels\" must be even");
}

}  // namespace

std::string sensitivity_keys() { return key_reference<SensitivityDeck>("Keys of a file for repose sensitivity."); }

SensitivityDeck read_sensitivity_deck(const std::string& text, const std::string& path) {
  require_study(text, path, "sensitivity");
  return read_described<SensitivityDeck>(text, path, {}, check);
}

}  // namespace repose
