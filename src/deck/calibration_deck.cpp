#include "deck/calibration_deck.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

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
}

template <class V>
void describe(V& v, PointDeck& p) {
  v("values", p.values, Unit::none, any_value, required, "one value per parameter");
}

template <class V>
void describe(V& v, AdaptiveDeck& a) {
  v("start", a.start, Unit::none, at_least(4), required, "points of the first design");
  v("batch", a.batch, Unit::none, at_least(1), required, "points decided at a time");
  v("budget", a.budget, Unit::none, at_least(4), required, "points in all, at most");
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
  if (deck.adaptive.enabled) points = static_cast<double>(deck.adaptive.budget);
  const double runs = points * static_cast<double>(deck.study.seeds);
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
    if (o.scale != ObservableScale::linear && !(o.laboratory > 0.0)) {
      errors.add(section + ".laboratory", "must be above 0 on this scale");
    }
  }
}

void check(CalibrationDeck& deck, DeckErrors& errors) {
  check_study(deck.study, errors);
  check_points(deck, errors);
  check_observables(deck, errors);
  check_number_of_runs(deck, errors);
  const AdaptiveDeck& a = deck.adaptive;
  if (a.enabled && a.budget < a.start) {
    errors.add("adaptive.budget", fmt::format("\"budget\" = {} must be at least \"start\" = {}", a.budget, a.start));
  }
}

}  // namespace

CalibrationDeck read_calibration_deck(const std::string& text, const std::string& path) {
  return read_described<CalibrationDeck>(text, path, {}, check);
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
