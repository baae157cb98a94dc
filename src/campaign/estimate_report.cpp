#include "campaign/estimate_report.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "campaign/level_report.h"
#include "campaign/observables.h"
#include "campaign/posterior_report.h"
#include "campaign/surface_json.h"
#include "files/json_text.h"

namespace repose {
namespace {

using Json = nlohmann::ordered_json;

Json list_of(std::span<const double> values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(json_number(value));
  return list;
}

Json part_json(const RegionPart& part) {
  Json intervals = Json::array();
  for (const ConfidenceInterval& interval : part.intervals) intervals.push_back(interval_json(interval));
  return {{"intervals", intervals}};
}

Json parts_json(const Estimate& estimate) {
  Json parts = Json::array();
  for (const RegionPart& part : estimate.parts) parts.push_back(part_json(part));
  return parts;
}

Json point_json(const CalibratedPoint& point) {
  Json covariance = Json::array();
  for (Index row = 0; row < point.covariance.rows(); ++row) {
    const Vector values = point.covariance.row(row);
    covariance.push_back(list_of({values.data(), static_cast<std::size_t>(values.size())}));
  }
  return {{"values", point.values},
          {"misfit", point.misfit},
          {"standard_errors", list_of(point.standard_errors)},
          {"covariance", covariance},
          {"part", point.part}};
}

Json nearest_json(const NearestPoint& nearest) {
  return {{"values", nearest.values}, {"misfit", json_number(nearest.misfit)}, {"acceptable", nearest.acceptable}};
}

Json observable_json(const ObservableDeck& deck, const ObservableData& data, double off_by) {
  const auto runs = std::count_if(data.values.begin(), data.values.end(), [](double v) { return !std::isnan(v); });
  Json json = {{"figure", deck.figure},
               {"laboratory", deck.laboratory},
               {"deviation", deck.deviation},
               {"repeats", deck.repeats},
               {"standard_error", data.laboratory.standard_error()},
               {"runs", runs},
               {"nearest_off_by", json_number(off_by)}};
  if (data.discrepancy > 0.0) json["discrepancy"] = data.discrepancy;
  return json;
}

std::string point_text(const CalibrationDeck& deck, const Estimate& estimate, const CalibratedPoint& point) {
  std::string text;
  for (std::size_t k = 0; k < point.values.size(); ++k) {
    const ConfidenceInterval& interval = estimate.parts[point.part].intervals[k];
    text +=
        fmt::format("  {:24} {:.4g} +- {:.2g}, {:.0f} % region {}\n", deck.study.parameters[k].name, point.values[k],
                    point.standard_errors[k], 100.0 * estimate.confidence, interval_text(interval));
  }
  return text;
}

std::string part_text(const CalibrationDeck& deck, const Estimate& estimate, std::size_t part) {
  std::string text;
  for (std::size_t k = 0; k < estimate.parts[part].intervals.size(); ++k) {
    text += fmt::format("  {:24} {:.0f} % region {}\n", deck.study.parameters[k].name, 100.0 * estimate.confidence,
                        interval_text(estimate.parts[part].intervals[k]));
  }
  return text;
}

/// The parts of the region in which there is no point. Without any point the first has the nearest one, with which it
/// is said.
std::string other_parts_text(const CalibrationDeck& deck, const Estimate& estimate) {
  std::string text;
  for (std::size_t part = estimate.points.empty() ? 1 : 0; part < estimate.parts.size(); ++part) {
    const auto is_in = [&](const CalibratedPoint& point) { return point.part == part; };
    if (std::any_of(estimate.points.begin(), estimate.points.end(), is_in)) continue;
    text += "part of the region without such a point\n" + part_text(deck, estimate, part);
  }
  return text;
}

std::string points_text(const CalibrationDeck& deck, const Estimate& estimate) {
  if (estimate.posterior && !estimate.points.empty()) return posterior_text(deck, estimate);
  std::string text;
  for (const CalibratedPoint& point : estimate.points) text += point_text(deck, estimate, point);
  return text;
}

/// With the part of the region that it is in, if it is acceptable.
std::string nearest_text(const CalibrationDeck& deck, const Estimate& estimate) {
  const NearestPoint& nearest = estimate.nearest;
  std::string text = "nearest point\n";
  for (std::size_t k = 0; k < nearest.values.size(); ++k) {
    text += fmt::format("  {:24} {:.4g}", deck.study.parameters[k].name, nearest.values[k]);
    if (!estimate.parts.empty()) {
      text += fmt::format(", {:.0f} % region {}", 100.0 * estimate.confidence,
                          interval_text(estimate.parts.front().intervals[k]));
    }
    text += "\n";
  }
  return text;
}

std::string off_by_text(const CalibrationDeck& deck, const NearestPoint& nearest) {
  std::string text;
  for (std::size_t k = 0; k < nearest.off_by.size(); ++k) {
    text += fmt::format("  {:24} off by {:+.2f} standard deviations\n", deck.observables[k].figure, nearest.off_by[k]);
  }
  return text;
}

/// What the runs have come to; of those that will be tried again why the first of them ended.
std::string runs_text(std::span<const StudyRun> runs, std::span<const RunRecord> records) {
  const std::string text = states_text(records) + "\n";
  const auto ended = std::find_if(records.begin(), records.end(),
                                  [](const RunRecord& r) { return r.state == RunState::waiting && !r.reason.empty(); });
  if (ended == records.end()) return text;
  return text + fmt::format("runs/{}: {}; the same command tries it again\n",
                            runs[static_cast<std::size_t>(ended - records.begin())].name, ended->reason);
}

/// Runs whose phase was ended by max_time: perhaps a bed that did not come to rest.
struct OverduePhase {
  std::string level;       ///< empty: there is one level
  std::string experiment;  ///< likewise
  std::string phase;
  std::ptrdiff_t overdue = 0;
  std::ptrdiff_t complete = 0;
};

std::vector<OverduePhase> overdue_phases(const CalibrationDeck& deck, std::span<const StudyRun> runs,
                                         std::span<const RunRecord> records) {
  using Test = std::pair<std::size_t, std::size_t>;  // level, experiment
  std::map<std::pair<Test, std::string>, std::ptrdiff_t> overdue;
  std::map<Test, std::ptrdiff_t> complete;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const Test test = {runs[i].level, runs[i].experiment};
    complete[test] += is_complete(records[i].state);
    for (const std::string& phase : records[i].overdue) ++overdue[{test, phase}];
  }
  std::vector<OverduePhase> phases;
  for (const auto& [where, count] : overdue) {
    const auto& [test, phase] = where;
    phases.push_back({.level = deck.levels.empty() ? "" : deck.levels[test.first].name,
                      .experiment = deck.experiments.empty() ? "" : deck.experiments[test.second].name,
                      .phase = phase,
                      .overdue = count,
                      .complete = complete[test]});
  }
  return phases;
}

std::string overdue_text(std::span<const OverduePhase> phases) {
  std::string text;
  for (const OverduePhase& p : phases) {
    text += fmt::format(
        "{}{}phase {} was ended by max_time in {} of {}\n", p.level.empty() ? "" : "level " + p.level + ": ",
        p.experiment.empty() ? "" : "experiment " + p.experiment + ": ", p.phase, p.overdue, p.complete);
  }
  return text;
}

Json overdue_json(std::span<const OverduePhase> phases) {
  Json list = Json::array();
  for (const OverduePhase& p : phases) {
    list.push_back({{"phase", p.phase}, {"runs", p.overdue}, {"of", p.complete}});
    if (!p.level.empty()) list.back()["level"] = p.level;
    if (!p.experiment.empty()) list.back()["experiment"] = p.experiment;
  }
  return list;
}

std::string text_of(const CalibrationDeck& deck, const Estimate& estimate, const std::string& runs,
                    const std::string& curves) {
  std::string text = runs;
  for (const ObservableDeck& o : deck.observables) {
    text += fmt::format("laboratory {:26} {:.5g}, standard error {:.2g} ({:.2g} / sqrt({}))", o.figure, o.laboratory,
                        o.deviation / std::sqrt(static_cast<double>(o.repeats)), o.deviation, o.repeats);
    text += o.model_deviation() > 0.0 ? fmt::format(", discrepancy of the model {:.2g}\n", o.model_deviation()) : "\n";
  }
  text += curves + estimate.verdict + "\n";
  text += points_text(deck, estimate);
  if (estimate.points.empty()) text += nearest_text(deck, estimate) + off_by_text(deck, estimate.nearest);
  return text + other_parts_text(deck, estimate);
}

/// What is said of an estimate with less: where it is, and its region.
Json other_json(const OtherEstimate& other) {
  Json points = Json::array();
  for (const CalibratedPoint& point : other.estimate.points) points.push_back(point_json(point));
  Json json = {{"verdict", other.estimate.verdict},
               {"points", points},
               {"parts", parts_json(other.estimate)},
               {"nearest", nearest_json(other.estimate.nearest)},
               {"half_width", json_number(other.estimate.half_width)}};
  if (other.estimate.posterior) json["posterior"] = posterior_json(*other.estimate.posterior);
  return json;
}

std::string other_text(const CalibrationDeck& deck, const OtherEstimate& other) {
  std::string text = fmt::format("{}: {}\n", other.what, other.estimate.verdict) + points_text(deck, other.estimate);
  if (other.estimate.points.empty() && other.estimate.nearest.acceptable) text += nearest_text(deck, other.estimate);
  return text + other_parts_text(deck, other.estimate);
}

}  // namespace

Report report_of(const Projection& projection, std::span<const StudyRun> runs) {
  const CalibrationDeck& deck = projection.deck;
  const std::span<const RunRecord> records = projection.records;
  const std::vector<ObservableData> data = observable_data(deck, records);
  const std::vector<OverduePhase> overdue = overdue_phases(deck, runs, records);
  require_surfaces(deck, runs, records);
  const Misfit misfit = misfit_of(deck, runs, records);
  const Estimate result = estimate(misfit, deck.confidence);
  Json parameters = Json::array();
  for (const ParameterDeck& p : deck.study.parameters) {
    parameters.push_back({{"name", p.name}, {"key", p.key}, {"min", p.min}, {"max", p.max}});
    if (result.posterior) parameters.back()["prior"] = prior_json(p);
  }
  Json observables = Json::array();
  for (std::size_t k = 0; k < data.size(); ++k) {
    observables.push_back(observable_json(deck.observables[k], data[k], result.nearest.off_by[k]));
    if (!deck.levels.empty()) observables.back()["links"] = links_json(deck, misfit, static_cast<Index>(k));
  }
  Json points = Json::array();
  for (const CalibratedPoint& point : result.points) points.push_back(point_json(point));
  Json json = {{"title", deck.study.title},
               {"confidence", result.confidence},
               {"limit", result.limit},
               {"verdict", result.verdict},
               {"parameters", parameters},
               {"observables", observables},
               {"points", points},
               {"parts", parts_json(result)},
               {"nearest", nearest_json(result.nearest)},
               {"half_width", json_number(result.half_width)}};
  if (!overdue.empty()) json["ended_by_max_time"] = overdue_json(overdue);
  if (!projection.curves.empty()) json["curves"] = curves_json(projection.curves);
  if (result.posterior) json["posterior"] = posterior_json(*result.posterior);
  if (misfit.parameters() == 2) json["surfaces"] = surface_json(misfit, deck, result.limit);
  std::string text =
      text_of(deck, result, runs_text(runs, records) + overdue_text(overdue), curves_text(projection.curves));
  if (!deck.levels.empty()) {
    json["levels"] = levels_json(deck, runs, records);
    text += levels_text(deck, runs, records) + links_text(deck, misfit);
  }
  if (deck.levels.size() > 1) {
    const OtherEstimate first = first_level_alone(deck, runs, records);
    json["first_level_alone"] = other_json(first);
    if (misfit.parameters() == 2) {
      json["first_level_alone"]["surfaces"] = surface_json(first.misfit, deck, first.estimate.limit);
    }
    text += other_text(deck, first);
  }
  for (const OtherEstimate& alone : experiments_alone(deck, runs, records)) {
    json["experiments_alone"][alone.what] = other_json(alone);
    text += other_text(deck, alone);
  }
  if (has_discrepancy(deck)) {
    const OtherEstimate exact = without_discrepancy(deck, runs, records);
    json["without_discrepancy"] = other_json(exact);
    text += other_text(deck, exact);
  }
  return {text, json_text(json, 1), result.posterior ? posterior_csv(deck, *result.posterior) : std::string()};
}

std::string progress_of(const Estimate& estimate) {
  if (!estimate.half_width) return estimate.verdict;
  return fmt::format("{}; the widest interval is {:.1f} % of its range to either side", estimate.verdict,
                     100.0 * *estimate.half_width);
}

}  // namespace repose
