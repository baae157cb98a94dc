#include "deck/sensitivity_deck.h"

#include <cmath>

#include <fmt/core.h>

#include "deck/key_reference.h"
#include "deck/read_described.h"
#include "deck/study_schema.h"

namespace repose {

template <class V>
void describe(V& v, MorrisDeck& m) {
  v("trajectories", m.trajectories, Unit::none, at_least(2), required, "walks, each of one step per parameter");
  v("levels", m.levels, Unit::none, at_least(2), optional, "values of each parameter; even");
}

template <class V>
void describe(V& v, SensitivityDeck& d) {
  describe_study(v, d.study);
  v("figures", d.figures, Unit::none, any_value, required, "keys of summary.json");
  v.section("morris", d.morris, optional, "Morris screening beside one at a time");
}

namespace {

void check(SensitivityDeck& deck, DeckErrors& errors) {
  check_study(deck.study, errors);
  if (deck.figures.empty()) errors.add("figures", "\"figures\" names none");
  for (std::size_t i = 0; i < deck.study.parameters.size(); ++i) {
    const ParameterDeck& p = deck.study.parameters[i];
    const std::string section = fmt::format("parameter.{}", i);
    if (p.points > 0 || !p.values.empty()) errors.add(section, "\"points\" and \"values\" belong to a calibration");
    if (p.prior != ParameterPrior::uniform || !std::isnan(p.prior_mean) || !std::isnan(p.prior_deviation))
      errors.add(section + ".prior", "a prior belongs to a calibration");
    if (std::isnan(p.fixed)) errors.add(section, "[[parameter]] lacks \"fixed\" (its value while another changes)");
  }
  constexpr std::int64_t most = 100000;
  if (deck.study.seeds > most || deck.morris.trajectories > most || deck.morris.levels > most) {
    errors.add("seeds", fmt::format("at most {} seeds, trajectories and levels are taken", most));
  }
  if (deck.morris.levels % 2 != 0) errors.add("morris.levels", "\"levels\" must be even");
}

}  // namespace

std::string sensitivity_keys() { return key_reference<SensitivityDeck>("Keys of a file for repose sensitivity."); }

SensitivityDeck read_sensitivity_deck(const std::string& text, const std::string& path) {
  return read_described<SensitivityDeck>(text, path, {}, check);
}

}  // namespace repose
