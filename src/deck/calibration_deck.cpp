#include "deck/calibration_deck.h"

#include <cmath>
#include <utility>

#include "deck/check_calibration.h"
#include "deck/deck_kind.h"
#include "deck/key_reference.h"
#include "deck/read_described.h"
#include "deck/study_schema.h"

namespace repose {

constexpr auto enumerators(ObservableScale) {
  return std::array<std::string_view, 3>{"linear", "square_root", "logarithm"};
}

template <class V>
void describe(V& v, ObservableDeck& o) {
  v("curve", o.curve, Unit::none, any_value, optional_else("none; this or figure"),
    "CSV with the columns x, y, deviation, relative to this file");
  const bool curve = o.is_curve();
  v("figure", o.figure, Unit::none, any_value, required.when(!curve, "without curve"), "key of summary.json");
  v("laboratory", o.laboratory, Unit::none, any_value, required.when(!curve, "without curve"),
    "measured mean, in the unit of the figure");
  v("deviation", o.deviation, Unit::none, at_least(0), required.when(!curve, "without curve"),
    "standard deviation of one measurement");
  v("name", o.name, Unit::none, any_value, required.when(curve, "with curve"), "name in tables, used once");
  v("series", o.series, Unit::none, any_value, required.when(curve, "with curve"),
    "table that a run writes, such as series.csv");
  v("x", o.x, Unit::none, any_value, required.when(curve, "with curve"), "its column to compare over");
  v("y", o.y, Unit::none, any_value, required.when(curve, "with curve"), "its column to compare");
  v("phase", o.phase, Unit::none, any_value, optional_else("all rows").when(curve, "with curve"),
    "whose rows count, x from its begin");
  v("correlation_length", o.correlation_length, Unit::none, at_least(0),
    optional_else("that of the curve").when(curve, "with curve"),
    "over which deviations of the laboratory are alike, in the unit of x");
  v("components", o.components, Unit::none, at_least(1), optional.when(curve, "with curve"),
    "onto which it is projected, at most");
  v("repeats", o.repeats, Unit::none, at_least(1), optional, "measurements behind the mean");
  v("deviation_is_known", o.deviation_is_known, Unit::none, any_value, optional,
    "false: the deviation is an estimate from these repeats");
  v("scale", o.scale, Unit::none, any_value, optional.when(!curve, "without curve"),
    "on which the surface is built: square_root suits counts");
  v("flowing_only", o.flowing_only, Unit::none, any_value, optional,
    "true: a mass of runs whose hole is not plugged alone");
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
  v("ranks_per_run", l.ranks_per_run, Unit::none, at_least(1), optional_else("that of the file"),
    "ranks that work on one run");
  v("start", l.start, Unit::none, at_least(4), optional_else("that of [adaptive]"), "points of its first design");
}

template <class V>
void describe(V& v, ExperimentLevelDeck& l) {
  v("name", l.name, Unit::none, any_value, required, "of a [[level]]");
  v("base", l.base, Unit::none, any_value, optional_else("that of the experiment"),
    "deck to run, relative to this file");
  v("set", l.set, Unit::none, any_value, optional, "keys of its deck to replace, after those of the level");
  v("seeds", l.seeds, Unit::none, at_least(1), optional_else("those of the level"), "runs at each of its points");
}

template <class V>
void describe(V& v, ExperimentDeck& e) {
  v("name", e.name, Unit::none, any_value, required, "name in tables and folders, used once");
  v("base", e.base, Unit::none, any_value, optional_else("that of the file"), "deck to run, relative to this file");
  v("set", e.set, Unit::none, any_value, optional, "keys of its deck to replace, after those of the file");
  v("seeds", e.seeds, Unit::none, at_least(1), optional_else("those of the file"), "runs at each point");
  v.sections("observable", e.observables, required, "a figure or a curve of this test and what the laboratory has");
  v.sections("level", e.levels, optional, "what this test changes at a level of the model");
}

template <class V>
void describe(V& v, PointDeck& p) {
  v("values", p.values, Unit::none, any_value, required, "one value per parameter");
  v("level", p.level, Unit::none, any_value, optional_else("all"), "with [adaptive]: name of that at which it is run");
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
  v("confidence", d.confidence, Unit::none, Range{.min = 0, .max = 1, .excludes_min = true, .excludes_max = true},
    optional, "of the region");
  describe_study(v, d.study, optional_else("none; each experiment then needs its own"));
  v.sections("point", d.points, optional, "a point to run at, instead of a grid, or beside what [adaptive] decides on");
  v.sections("observable", d.observables, optional, "a figure or a curve and what the laboratory has");
  v.sections("level", d.levels, optional, "a level of the model, the cheapest first; the last one counts");
  v.sections("experiment", d.experiments, optional, "one of several tests that share the parameters");
  v.section("adaptive", d.adaptive, optional, "decide on the points as the results come in");
}

std::string calibration_keys() { return key_reference<CalibrationDeck>("Keys of a file for repose calibrate."); }

CalibrationDeck read_calibration_deck(const std::string& text, const std::string& path) {
  require_study(text, path, "calibrate");
  return read_described<CalibrationDeck>(text, path, {}, check_calibration);
}

double ObservableDeck::model_deviation() const {
  return discrepancy > 0.0 ? discrepancy : discrepancy_share * std::fabs(laboratory);
}

StudyDeck study_of_level(const CalibrationDeck& deck, std::size_t level, std::size_t experiment) {
  StudyDeck study = deck.study;
  const auto change = [&](const auto& own) {
    if (!own.base.empty()) study.base = own.base;
    study.set.insert(study.set.end(), own.set.begin(), own.set.end());
    if (own.seeds > 0) study.seeds = own.seeds;
  };
  if (!deck.experiments.empty()) change(deck.experiments.at(experiment));
  if (deck.levels.empty()) return study;
  change(deck.levels.at(level));
  if (deck.levels[level].ranks_per_run > 0) study.ranks_per_run = deck.levels[level].ranks_per_run;
  if (deck.experiments.empty()) return study;
  for (const ExperimentLevelDeck& own : deck.experiments[experiment].levels) {
    if (own.name == deck.levels[level].name) change(own);
  }
  return study;
}

std::int64_t start_of_level(const CalibrationDeck& deck, std::size_t level) {
  const bool has_own = !deck.levels.empty() && deck.levels.at(level).start > 0;
  return has_own ? deck.levels[level].start : deck.adaptive.start;
}

std::vector<std::vector<double>> points_of_level(const CalibrationDeck& deck, std::size_t level) {
  std::vector<std::vector<double>> points;
  for (const PointDeck& point : deck.points) {
    const bool is_run = point.level.empty() || (level < deck.levels.size() && point.level == deck.levels[level].name);
    if (is_run) points.push_back(point.values);
  }
  return points;
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
