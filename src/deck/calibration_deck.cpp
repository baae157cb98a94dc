#include "deck/calibration_deck.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "deck/plain_name.h"
#include "deck/read_described.h"
#include "deck/study_schema.h"

namespace repose {

constexpr auto enumerators(ObservableScale) {
  return std::array<std::string_view, 3>{"linear", "square_root", "logarithm"};
}

template <class V>
void describe(V& v, ObservableDeck& o) {
  v("figure", o.figure, Unit::none, any_value, required, "key of summary.json");
  v("laboratory", o.laboratory, Unit::none, any_value, required, "measured mean, in the unit of the figure");
  v("deviation", o.deviation, Unit::none, at_least(0), required, "standard deviation of one measurement");
  v("repeats", o.repeats, Unit::none, at_least(1), optional, "measurements behind the mean");
  v("deviation_is_known", o.deviation_is_known, Unit::none, any_value, optional,
    "false: the deviation is an estimate from these repeats");
  v("scale", o.scale, Unit::none, any_value, optional, "on which the surface is built: square_root suits counts");
  v("discrepancy", o.discrepancy, Unit::none, at_least(0), optional,
    "standard deviation of what the model cannot be expected to meet");
  v("discrepancy_share", o.discrepancy_share, Unit::none, at_least(0), optional,
    "the same over the laboratory's value");
}

template <class V>
void describe(V& v, LevelDeck& l) {
  v("name", l.name, Unit::none, any_value, required, "name in tables and folders, used once");
  v("base", l.base, Unit::none, any_value, optional_else("that of the file"), "deck to run, relative to this file");
  v("set", l.set, Unit::none, any_value, optional, "keys of its deck to replace, after those of the file");
  v("seeds", l.seeds, Unit::none, at_least(1), optional_else("those of the file"), "runs at each of its points");
  v("start", l.start, Unit::none, at_least(4), optional_else("that of [adaptive]"), "points of its first design");
}

template <class V>
void describe(V& v, PointDeck& p) {
  v("values", p.values, Unit::none, any_value, required, "one value per parameter");
}

template <class V>
void describe(V& v, AdaptiveDeck& a) {
  v("start", a.start, Unit::none, at_least(4), required, "points of the first design");
  v("batch", a.batch, Unit::none, at_least(1), required, "points decided at a time");
  v("budget", a.budget, Unit::none, at_least(4), optional_else("none; this or budget_core_hours"),
    "points in all, at most");
  v("budget_core_hours", a.budget_core_hours, Unit::none, above(0), optional_else("none; this or budget"),
    "core-hours in all, at core_speed");
  v("core_speed", a.core_speed, Unit::none, above(0), optional, "particle-steps per second that a core is taken to do");
  v("half_width", a.half_width, Unit::none, above_to(0, 1), required,
    "of the widest interval over its range, at which the search ends");
}

template <class V>
void describe(V& v, CalibrationDeck& d) {
  describe_study(v, d.study);
  v("confidence", d.confidence, Unit::none, Range{.min = 0, .max = 1, .excludes_min = true, .excludes_max = true},
    optional, "of the region");
  v.sections("point", d.points, optional, "a point to run at, instead of a grid");
  v.sections("observable", d.observables, required, "a figure and its laboratory value");
  v.sections("level", d.levels, optional, "a level of the model, the cheapest first; the last one counts");
  v.section("adaptive", d.adaptive, optional, "decide on the points as the results come in");
}

namespace {

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
  if (!deck.points.empty() && deck.adaptive.enabled)
    errors.add("adaptive", "[adaptive] and [[point]] exclude each other");
  for (std::size_t i = 0; i < deck.points.size(); ++i) {
    const std::vector<double>& values = deck.points[i].values;
    const std::string key = fmt::format("point.{}.values", i);
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
      if (deck.points[j].values == values) errors.add(key, "this point stands here twice");
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
  if (deck.adaptive.enabled) points = static_cast<double>(std::max(deck.adaptive.budget, deck.adaptive.start));
  double runs = points * static_cast<double>(deck.study.seeds);
  if (!deck.levels.empty()) {
    runs = 0.0;
    for (std::size_t k = 0; k < deck.levels.size(); ++k) {
      runs += (deck.adaptive.enabled ? static_cast<double>(start_of_level(deck, k)) : points) *
              static_cast<double>(study_of_level(deck, k).seeds);
    }
  }
  if (runs > most) errors.add("parameter", fmt::format("these are {:.3g} runs; at most {:.0g} are taken", runs, most));
}

void check_observables(const CalibrationDeck& deck, DeckErrors& errors) {
  for (std::size_t i = 0; i < deck.observables.size(); ++i) {
    const ObservableDeck& o = deck.observables[i];
    const std::string section = fmt::format("observable.{}", i);
    for (std::size_t j = 0; j < i; ++j) {
      if (deck.observables[j].figure != o.figure) continue;
      errors.add(section + ".figure", fmt::format("\"{}\" is another observable's figure, too", o.figure));
    }
    if (!o.deviation_is_known && o.repeats < 2) {
      errors.add(section + ".repeats", "a deviation estimated from the repeats takes at least 2");
    }
    if (o.discrepancy > 0.0 && o.discrepancy_share > 0.0) {
      errors.add(section + ".discrepancy", "\"discrepancy\" and \"discrepancy_share\" exclude each other");
    }
    if (o.scale != ObservableScale::linear && !(o.laboratory > 0.0)) {
      errors.add(section + ".laboratory", "must be above 0 on this scale");
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
    if (i > 0 && level.base == deck.levels[i - 1].base && level.set == deck.levels[i - 1].set)
      errors.add(section, fmt::format("is the same model as level \"{}\"", deck.levels[i - 1].name));
  }
}

void check_adaptive(const CalibrationDeck& deck, DeckErrors& errors) {
  const AdaptiveDeck& a = deck.adaptive;
  if (!a.enabled) return;
  if (a.budget == 0 && std::isnan(a.budget_core_hours))
    errors.add("adaptive", "[adaptive] lacks \"budget\" or \"budget_core_hours\"");
  double start = 0.0;
  for (std::size_t k = 0; k < deck.level_count(); ++k) start += static_cast<double>(start_of_level(deck, k));
  if (a.budget == 0 || static_cast<double>(a.budget) >= start) return;
  const char* what = deck.levels.empty() ? "\"start\"" : "\"start\" of all levels";
  errors.add("adaptive.budget", fmt::format("\"budget\" = {} must be at least {} = {}", a.budget, what, start));
}

void check(CalibrationDeck& deck, DeckErrors& errors) {
  check_study(deck.study, errors);
  check_priors(deck.study, errors);
  check_levels(deck, errors);
  check_points(deck, errors);
  check_observables(deck, errors);
  check_number_of_runs(deck, errors);
  check_adaptive(deck, errors);
}

}  // namespace

CalibrationDeck read_calibration_deck(const std::string& text, const std::string& path) {
  return read_described<CalibrationDeck>(text, path, {}, check);
}

double ObservableDeck::model_deviation() const {
  return discrepancy > 0.0 ? discrepancy : discrepancy_share * std::fabs(laboratory);
}

StudyDeck study_of_level(const CalibrationDeck& deck, std::size_t level) {
  StudyDeck study = deck.study;
  if (deck.levels.empty()) return study;
  const LevelDeck& own = deck.levels.at(level);
  if (!own.base.empty()) study.base = own.base;
  study.set.insert(study.set.end(), own.set.begin(), own.set.end());
  if (own.seeds > 0) study.seeds = own.seeds;
  return study;
}

std::int64_t start_of_level(const CalibrationDeck& deck, std::size_t level) {
  const bool has_own = !deck.levels.empty() && deck.levels.at(level).start > 0;
  return has_own ? deck.levels[level].start : deck.adaptive.start;
}

std::vector<std::vector<double>> points_of(const CalibrationDeck& deck) {
  if (deck.adaptive.enabled) return {};
  std::vector<std::vector<double>> points;
  if (!deck.points.empty()) {
    for (const PointDeck& point : deck.points) points.push_back(point.values);
    return points;
  }
  points.emplace_back();
  for (const ParameterDeck& parameter : deck.study.parameters) {
    std::vector<std::vector<double>> longer;
    for (const std::vector<double>& begun : points) {
      for (const double value : values_of(parameter)) {
        longer.push_back(begun);
        longer.back().push_back(value);
      }
    }
    points = std::move(longer);
  }
  return points;
}

}  // namespace repose
