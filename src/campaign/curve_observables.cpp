#include "campaign/curve_observables.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "campaign/curve_csv.h"
#include "campaign/observables.h"
#include "files/shared_file.h"
#include "run/measurements/measurement.h"

namespace repose {
namespace {

using Json = nlohmann::ordered_json;

Vector vector_of(const std::vector<double>& values) {
  return Eigen::Map<const Vector>(values.data(), static_cast<Index>(values.size()));
}

std::vector<double> values_of(const Vector& vector) { return {vector.begin(), vector.end()}; }

/// The steps of a phase, from the summary of a run.
StepWindow window_of(const Json& summary, const std::string& path, const ObservableDeck& o) {
  StepWindow window;
  std::string names;
  try {
    for (const Json& phase : summary.at("phases")) {
      window.last = window.first + phase.at("steps").get<std::int64_t>();
      const auto name = phase.at("name").get<std::string>();
      if (name == o.phase) return window;
      names += (names.empty() ? "" : ", ") + name;
      window.first = window.last;
    }
  } catch (const Json::exception&) {
    throw FileError(fmt::format("{}: \"phases\" is missing or wrong; remove the folder to run it again", path));
  }
  throw DeckError(fmt::format("observable \"{}\": {} has no phase \"{}\", but {}", o.figure, path, o.phase, names));
}

std::vector<double> curve_of_run(const std::string& folder, const ObservableDeck& o) {
  const std::string file = folder + "/" + o.series;
  if (!std::filesystem::exists(file)) {
    throw DeckError(
        fmt::format("observable \"{}\": runs write no {}; their tables are series.csv, walls.csv and those "
                    "of measurements",
                    o.figure, o.series));
  }
  const std::string text = read_whole_file(file);
  if (o.phase.empty()) return at_places(parse_run_curve(text, file, o, nullptr), file, o);
  const std::string summary = folder + "/summary.json";
  const StepWindow window = window_of(Json::parse(read_whole_file(summary), nullptr, false), summary, o);
  return at_places(parse_run_curve(text, file, o, &window), file, o);
}

/// The tables over time that runs of a deck write.
std::vector<std::string> tables_of(const Deck& deck) {
  std::vector<std::string> tables = {"series.csv"};
  if (!deck.walls.empty()) tables.emplace_back("walls.csv");
  for (const MeasurementKind& kind : measurement_kinds()) {
    if (!kind.is_enabled(deck)) continue;
    std::copy_if(kind.files.begin(), kind.files.end(), std::back_inserter(tables),
                 [](const std::string& file) { return file.ends_with(".csv"); });
  }
  return tables;
}

/// The curves of all runs that have one; nothing for the others.
std::vector<std::optional<Vector>> curves_of_runs(const ObservableDeck& o, const std::string& directory,
                                                  std::span<const StudyRun> runs, std::span<const RunRecord> records) {
  std::vector<std::optional<Vector>> curves(runs.size());
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (runs[i].experiment == o.experiment && counts(records[i], o))
      curves[i] = vector_of(curve_of_run(folder_of(directory, runs[i]), o));
  }
  return curves;
}

MeasuredCurve measured_curve(const ObservableDeck& o) {
  const LaboratoryCurve& curve = o.laboratory_curve;
  const double whole = curve.x.back() - curve.x.front();
  return {vector_of(curve.x), vector_of(curve.y), vector_of(curve.deviation),
          std::isnan(o.correlation_length) ? whole : o.correlation_length};
}

CurveComponents components_of(const ObservableDeck& o, std::size_t parameters, std::span<const StudyRun> runs,
                              std::span<const std::optional<Vector>> curves) {
  std::map<std::vector<double>, std::size_t> points;
  std::vector<CurveRun> own;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!curves[i]) continue;
    const std::size_t point = points.try_emplace(runs[i].values, points.size()).first->second;
    own.push_back({.point = point, .level = runs[i].level, .y = *curves[i]});
  }
  const auto most = static_cast<Index>(o.components);
  return {o.figure, measured_curve(o), own, std::min(most, static_cast<Index>(parameters)), most};
}

/// In the unit of y, at each x.
Vector model_deviation(const ObservableDeck& o) {
  const Vector y = vector_of(o.laboratory_curve.y);
  return o.discrepancy > 0.0 ? Vector::Constant(y.size(), o.discrepancy) : Vector(o.discrepancy_share * y.cwiseAbs());
}

ObservableDeck component(const ObservableDeck& curve, Index k, const CurveComponents& components) {
  ObservableDeck o = curve;
  o.figure = fmt::format("{}.{}", curve.figure, k + 1);
  o.laboratory = components.laboratory()[k];
  o.deviation = 1.0;
  o.discrepancy = components.deviation_of(model_deviation(curve))[k];
  o.discrepancy_share = 0.0;
  return o;
}

}  // namespace

void read_curves(const Communicator& world, const CurvePath& path_of, CalibrationDeck& deck) {
  for (ObservableDeck& o : deck.observables) {
    if (!o.is_curve()) continue;
    const std::string path = path_of(o);
    o.laboratory_curve = parse_curve_csv(read_shared_file(world, path), path);
  }
}

void check_curves(const CalibrationDeck& deck, const Deck& run, std::size_t experiment) {
  std::vector<std::string> phases;
  for (const PhaseDeck& phase : run.phases) phases.push_back(phase.name);
  const std::vector<std::string> tables = tables_of(run);
  const auto has = [](const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  for (const ObservableDeck& o : deck.observables) {
    if (!o.is_curve() || o.experiment != experiment) continue;
    if (!o.phase.empty() && !has(phases, o.phase)) {
      throw DeckError(fmt::format("observable \"{}\": the deck has no phase \"{}\", but {}", o.figure, o.phase,
                                  fmt::join(phases, ", ")));
    }
    if (has(tables, o.series)) continue;
    throw DeckError(fmt::format("observable \"{}\": runs write no {}; their tables are {}", o.figure, o.series,
                                fmt::join(tables, ", ")));
  }
}

void check_curves(const CalibrationDeck& deck, const std::string& folder, const StudyRun& run) {
  const RunRecord record = read_run_folder(folder, {});
  for (const ObservableDeck& o : deck.observables) {
    if (o.is_curve() && o.experiment == run.experiment && counts(record, o)) curve_of_run(folder, o);
  }
}

std::string curve_copy(const ObservableDeck& observable) { return fmt::format("curve_{}.csv", observable.figure); }

Projection project_curves(const CalibrationDeck& deck, const std::string& directory, std::span<const StudyRun> runs,
                          std::span<const RunRecord> records) {
  Projection result = {deck, {records.begin(), records.end()}, {}};
  result.deck.observables.clear();
  for (RunRecord& record : result.records) record.figures.clear();
  std::size_t figure = 0;
  for (const ObservableDeck& o : deck.observables) {
    if (!o.is_curve()) {
      result.deck.observables.push_back(o);
      for (std::size_t i = 0; i < runs.size(); ++i) result.records[i].figures.push_back(records[i].figures[figure]);
      ++figure;
      continue;
    }
    const auto curves = curves_of_runs(o, directory, runs, records);
    CurveComponents components = components_of(o, deck.study.parameters.size(), runs, curves);
    for (Index k = 0; k < components.count(); ++k) result.deck.observables.push_back(component(o, k, components));
    for (std::size_t i = 0; i < runs.size(); ++i) {
      std::vector<std::optional<double>>& figures = result.records[i].figures;
      figures.resize(figures.size() + static_cast<std::size_t>(components.count()));
      if (!curves[i]) continue;
      const Vector scores = components.scores(*curves[i]);
      std::copy(scores.begin(), scores.end(), figures.end() - components.count());
    }
    result.curves.push_back({o, std::move(components)});
  }
  return result;
}

std::string curves_text(std::span<const ProjectedCurve> curves) {
  std::string text;
  for (const auto& [o, components] : curves) {
    text += fmt::format(
        "curve {:31} {} points on {} component{}, which leave out {:.2g} % of how the runs differ; the laboratory's "
        "curve is {:.2g} of its deviations off them\n",
        o.figure, o.laboratory_curve.x.size(), components.count(), components.count() == 1 ? "" : "s",
        100.0 * components.left_out(), components.laboratory_rest());
  }
  return text;
}

Json curves_json(std::span<const ProjectedCurve> curves) {
  Json list = Json::array();
  for (const auto& [o, components] : curves) {
    const Vector none = Vector::Zero(components.count());
    const Vector mean = components.curve(none);
    Json shapes = Json::array();
    for (Index k = 0; k < components.count(); ++k) {
      Vector one = none;
      one[k] = 1.0;
      shapes.push_back(values_of(components.curve(one) - mean));
    }
    list.push_back({{"name", o.figure},
                    {"x_column", o.x},
                    {"y_column", o.y},
                    {"x", o.laboratory_curve.x},
                    {"laboratory", o.laboratory_curve.y},
                    {"deviation", o.laboratory_curve.deviation},
                    {"repeats", o.repeats},
                    {"mean", values_of(mean)},
                    {"components", shapes},
                    {"projected_laboratory", values_of(components.curve(components.laboratory()))},
                    {"left_out", components.left_out()},
                    {"laboratory_rest", components.laboratory_rest()}});
  }
  return list;
}

}  // namespace repose
