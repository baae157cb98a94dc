#include "deck/check_calibration.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "deck/plain_name.h"

namespace repose {
namespace {

bool has_level(const CalibrationDeck& deck, const std::string& name) {
  return std::any_of(deck.levels.begin(), deck.levels.end(),
                     [&](const LevelDeck& level) { return level.name == name; });
}

void check_level_of_point(const CalibrationDeck& deck, const std::string& level, const std::string& key,
                          DeckErrors& errors) {
  if (level.empty()) return;
  if (!deck.adaptive.enabled) {
    errors.add(key, "\"level\" belongs to a search, which takes [adaptive]");
  } else if (!has_level(deck, level)) {
    errors.add(key, fmt::format("\"{}\" is no [[level]] of the file", level));
  }
}

/// How many points a search begins with at a level.
double first_points(const CalibrationDeck& deck, std::size_t level) {
  return static_cast<double>(start_of_level(deck, level)) + static_cast<double>(points_of_level(deck, level).size());
}

void check_points(const CalibrationDeck& deck, DeckErrors& errors) {
  const std::vector<ParameterDeck>& parameters = deck.study.parameters;
  const bool is_grid = deck.points.empty() && !deck.adaptive.enabled;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const ParameterDeck& p = parameters[i];
    if (!std::isnan(p.fixed))
      errors.add(fmt::format("parameter.{}.fixed", i), "\"fixed\" belongs to a sensitivity deck");
    if ((p.points > 0 || !p.values.empty()) == is_grid) continue;
    errors.add(fmt::format("parameter.{}", i),
               is_grid ? "[[parameter]] lacks \"points\" or \"values\"; or list points as [[point]]"
                       : "\"points\" and \"values\" make a grid, which [[point]] and [adaptive] exclude");
  }
  for (std::size_t i = 0; i < deck.points.size(); ++i) {
    const auto& [values, level] = deck.points[i];
    const std::string key = fmt::format("point.{}.values", i);
    check_level_of_point(deck, level, fmt::format("point.{}.level", i), errors);
    if (values.size() != parameters.size()) {
      errors.add(key, fmt::format("\"values\" must have {}, one per parameter", parameters.size()));
      continue;
    }
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (values[k] >= parameters[k].min && values[k] <= parameters[k].max) continue;
      errors.add(key, fmt::format("{} = {} is not from {} to {}", parameters[k].name, values[k], parameters[k].min,
                                  parameters[k].max));
    }
    for (std::size_t j = 0; j < i; ++j) {
      const PointDeck& other = deck.points[j];
      const bool at_one_level = level.empty() || other.level.empty() || level == other.level;
      if (at_one_level && other.values == values) errors.add(key, "this point stands here twice");
    }
  }
}

/// What is meant to be run ends before this.
void check_number_of_runs(const CalibrationDeck& deck, DeckErrors& errors) {
  constexpr double most = 1e6;
  double points = 1.0;
  for (const ParameterDeck& p : deck.study.parameters) {
    points *=
        p.points > 0 ? static_cast<double>(p.points) : static_cast<double>(std::max<std::size_t>(1, p.values.size()));
  }
  if (!deck.points.empty()) points = static_cast<double>(deck.points.size());
  if (deck.adaptive.enabled) points = std::max(static_cast<double>(deck.adaptive.budget), first_points(deck, 0));
  double runs = 0.0;
  for (std::size_t k = 0; k < deck.level_count(); ++k) {
    const bool has_start = deck.adaptive.enabled && !deck.levels.empty();
    for (std::size_t e = 0; e < deck.experiment_count(); ++e) {
      runs += (has_start ? first_points(deck, k) : points) * static_cast<double>(study_of_level(deck, k, e).seeds);
    }
  }
  if (runs > most) errors.add("parameter", fmt::format("these are {:.3g} runs; at most {:.0g} are taken", runs, most));
}

void check_observable(const ObservableDeck& o, const std::string& section, DeckErrors& errors) {
  if (!o.deviation_is_known && o.repeats < 2) {
    errors.add(section + ".repeats", "a deviation estimated from the repeats takes at least 2");
  }
  if (o.discrepancy > 0.0 && o.discrepancy_share > 0.0) {
    errors.add(section + ".discrepancy", "\"discrepancy\" and \"discrepancy_share\" exclude each other");
  }
  if (o.scale == ObservableScale::logarithm && !(o.laboratory > 0.0)) {
    errors.add(section + ".laboratory", "\"laboratory\" must be above 0 on the scale of logarithms");
  }
  if (o.scale == ObservableScale::square_root && !(o.laboratory >= 0.0)) {
    errors.add(section + ".laboratory", "\"laboratory\" must be at least 0 on the scale of square roots");
  }
  if (!o.is_curve()) return;
  check_plain_name(o.name, section + ".name", errors);
  if (o.series.find('/') != std::string::npos)
    errors.add(section + ".series", "\"series\" is a file in the folder of a run");
}

/// Those of the study or of one experiment, with what they are called in tables.
void check_observables(std::vector<ObservableDeck>& observables, const std::string& sections, DeckErrors& errors) {
  for (std::size_t i = 0; i < observables.size(); ++i) {
    ObservableDeck& o = observables[i];
    const std::string section = fmt::format("{}observable.{}", sections, i);
    check_observable(o, section, errors);
    o.key = o.figure;
    if (o.is_curve()) o.figure = o.name;
    for (std::size_t j = 0; j < i; ++j) {
      if (observables[j].figure != o.figure) continue;
      errors.add(section + (o.is_curve() ? ".name" : ".figure"),
                 fmt::format("\"{}\" is another observable's {}, too", o.figure, o.is_curve() ? "name" : "figure"));
    }
  }
}

/// The observables of the experiments become those of the deck.
void check_experiments(CalibrationDeck& deck, DeckErrors& errors) {
  if (deck.experiments.empty()) {
    if (deck.study.base.empty()) errors.add("base", "the file lacks \"base\", the deck to run");
    if (deck.observables.empty())
      errors.add("observable", "the file lacks [[observable]]; or [[experiment]] with their own");
    return;
  }
  if (!deck.observables.empty()) {
    errors.add("observable", "with [[experiment]] each observable is an [[experiment.observable]]");
    return;
  }
  for (std::size_t i = 0; i < deck.levels.size(); ++i) {
    if (deck.levels[i].base.empty()) continue;
    errors.add(fmt::format("level.{}.base", i), "with [[experiment]] \"base\" stands in [[experiment.level]]");
  }
  for (std::size_t i = 0; i < deck.experiments.size(); ++i) {
    ExperimentDeck& e = deck.experiments[i];
    const std::string section = fmt::format("experiment.{}", i);
    check_plain_name(e.name, section + ".name", errors);
    if (e.base.empty() && deck.study.base.empty())
      errors.add(section, "[[experiment]] lacks \"base\", and the file has none");
    for (std::size_t j = 0; j < i; ++j) {
      if (deck.experiments[j].name == e.name)
        errors.add(section + ".name", fmt::format("\"{}\" names another experiment, too", e.name));
    }
    check_observables(e.observables, section + ".", errors);
    for (std::size_t k = 0; k < e.levels.size(); ++k) {
      const std::string& name = e.levels[k].name;
      const std::string key = fmt::format("{}.level.{}.name", section, k);
      if (!has_level(deck, name)) errors.add(key, fmt::format("\"{}\" is no [[level]] of the file", name));
      if (std::any_of(e.levels.begin(), e.levels.begin() + static_cast<std::ptrdiff_t>(k),
                      [&](const ExperimentLevelDeck& before) { return before.name == name; }))
        errors.add(key, fmt::format("\"{}\" stands here twice", name));
    }
    for (ObservableDeck o : e.observables) {
      o.figure = e.name + "." + o.figure;
      o.experiment = i;
      deck.observables.push_back(std::move(o));
    }
  }
}

void check_levels(const CalibrationDeck& deck, DeckErrors& errors) {
  for (std::size_t i = 0; i < deck.levels.size(); ++i) {
    const LevelDeck& level = deck.levels[i];
    const std::string section = fmt::format("level.{}", i);
    check_plain_name(level.name, section + ".name", errors);
    for (std::size_t j = 0; j < i; ++j) {
      if (deck.levels[j].name == level.name)
        errors.add(section + ".name", fmt::format("\"{}\" names another level, too", level.name));
    }
    if (level.start > 0 && !deck.adaptive.enabled)
      errors.add(section + ".start", "\"start\" belongs to a search, which takes [adaptive]");
    bool is_same = i > 0;
    for (std::size_t e = 0; is_same && e < deck.experiment_count(); ++e) {
      const StudyDeck own = study_of_level(deck, i, e);
      const StudyDeck below = study_of_level(deck, i - 1, e);
      is_same = own.base == below.base && own.set == below.set;
    }
    if (is_same) errors.add(section, fmt::format("is the same model as level \"{}\"", deck.levels[i - 1].name));
  }
}

void check_adaptive(const CalibrationDeck& deck, DeckErrors& errors) {
  const AdaptiveDeck& a = deck.adaptive;
  if (!a.enabled) return;
  if (a.budget == 0 && std::isnan(a.budget_core_hours))
    errors.add("adaptive", "[adaptive] lacks \"budget\" or \"budget_core_hours\"");
  double start = 0.0;
  for (std::size_t k = 0; k < deck.level_count(); ++k) start += first_points(deck, k);
  if (a.budget == 0 || static_cast<double>(a.budget) >= start) return;
  std::string what = deck.levels.empty() ? "\"start\"" : "\"start\" of all levels";
  if (!deck.points.empty()) what += " and each [[point]]";
  errors.add("adaptive.budget", fmt::format("\"budget\" = {} must be at least {} = {}", a.budget, what, start));
}

}  // namespace

void check_calibration(CalibrationDeck& deck, DeckErrors& errors) {
  check_study(deck.study, errors);
  check_observables(deck.observables, "", errors);
  check_experiments(deck, errors);
  std::vector<std::string> figures;
  for (const ObservableDeck& o : deck.observables) figures.push_back(o.figure);
  check_column_names(deck.study, figures, errors);
  check_priors(deck.study, errors);
  check_levels(deck, errors);
  check_points(deck, errors);
  check_number_of_runs(deck, errors);
  check_adaptive(deck, errors);
}

}  // namespace repose
