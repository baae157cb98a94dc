#include "campaign/validate.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "campaign/planned_work.h"
#include "comm/agreement.h"
#include "deck/validation_deck.h"
#include "files/atomic_file.h"
#include "files/directory.h"
#include "files/json_text.h"
#include "files/results_directory.h"
#include "files/shared_file.h"
#include "output/summary.h"
#include "run/run_plan.h"
#include "run/summary_figures.h"

namespace repose {
namespace {

using Json = nlohmann::ordered_json;

/// How a figure is shown, from the unit at the end of its key.
struct Display {
  std::string name;  ///< "discharged mass, g"
  double factor;
  bool is_count;
};

Display display_of(const std::string& figure) {
  struct Unit {
    std::string_view ending;  ///< the longer before what it ends with
    const char* shown;
    double factor;
  };
  constexpr Unit units[] = {{"_kg_m3", ", kg/m3", 1.0}, {"_kg_s", ", g/s", 1e3}, {"_kg", ", g", 1e3},
                            {"_deg", ", degrees", 1.0}, {"_m", ", mm", 1e3},     {"_s", ", s", 1.0}};
  std::string name = figure;
  std::string shown;
  double factor = 1.0;
  for (const Unit& unit : units) {
    if (!name.ends_with(unit.ending)) continue;
    name.erase(name.size() - unit.ending.size());
    shown = unit.shown;
    factor = unit.factor;
    break;
  }
  for (char& c : name) c = c == '_' || c == '.' ? ' ' : c;
  return {name + shown, factor, shown.empty()};
}

Json comparison_json(const ComparisonDeck& c, const Json& summary) {
  return {{"figure", c.figure},
          {"here", json_number(figure_in(summary, c.figure))},
          {"error", json_number(error_in(summary, c.figure))},
          {"laboratory", c.laboratory},
          {"deviation", json_number(c.deviation)},
          {"published", json_number(c.published)}};
}

std::string cell(const Json& value, const Json& error, const Display& display) {
  if (value.is_null()) return "none";
  const auto shown = [&](const Json& v, int digits) {
    const double scaled = display.factor * v.get<double>();
    return display.is_count ? fmt::format("{:.{}g}", scaled, digits) : fmt::format("{:#.{}g}", scaled, digits);
  };
  return error.is_null() ? shown(value, 4) : fmt::format("{} +- {}", shown(value, 4), shown(error, 2));
}

std::string difference(const Json& value, const Json& laboratory) {
  if (value.is_null() || laboratory.get<double>() == 0.0) return "-";
  return fmt::format("{:+.1f} %", 100.0 * (value.get<double>() / laboratory.get<double>() - 1.0));
}

std::string table_of(const ValidationDeck& deck, const Json& cases) {
  const std::string published = deck.published.empty() ? "published" : deck.published;
  std::string text = fmt::format("| case | figure | laboratory | {} | difference | here | difference |\n", published);
  text += "|---|---|---|---|---|---|---|\n";
  for (const Json& one : cases) {
    for (const Json& c : one["comparisons"]) {
      const Display display = display_of(c["figure"].get<std::string>());
      text += fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", one["name"].get<std::string>(), display.name,
                          cell(c["laboratory"], c["deviation"], display), cell(c["published"], nullptr, display),
                          difference(c["published"], c["laboratory"]), cell(c["here"], c["error"], display),
                          difference(c["here"], c["laboratory"]));
    }
  }
  return text;
}

std::vector<std::string> overrides_of(const ValidationCaseDeck& one, const RunRequest& request) {
  std::vector<std::string> overrides = one.set;
  overrides.insert(overrides.end(), request.overrides.begin(), request.overrides.end());
  return overrides;
}

/// Runs the case, unless that is done already, and compares.
Json run_case(const Communicator& comm, const ValidationCaseDeck& one, const RunRequest& request,
              const StopAsked& stop_asked) {
  RunRequest run = request;
  run.deck = path_beside(request.deck, one.deck);
  run.overrides = overrides_of(one, request);
  run.output = fmt::format("{}/{}", request.output, one.name);
  run.restart = true;
  if (comm.is_root()) request.log.say("case " + one.name);
  run_file(comm, run, stop_asked);
  Json result;
  agree_after_root(comm, [&] {
    const Json summary = Json::parse(read_whole_file(run.output + "/summary.json"));
    Json comparisons = Json::array();
    for (const ComparisonDeck& c : one.comparisons) comparisons.push_back(comparison_json(c, summary));
    result = {{"name", one.name},
              {"state_hash", summary["state_hash"]},
              {"steps", summary["steps"]},
              {"particles", summary["particles"]["inserted"]},
              {"wall_seconds", summary["wall_seconds"]},
              {"ranks", summary["ranks"]},
              {"comparisons", comparisons}};
  });
  return result;
}

/// Leaves the cases with these names, if any are given.
void choose_cases(const std::vector<std::string>& only, const std::string& path, ValidationDeck& deck) {
  if (only.empty()) return;
  const auto is_in = [](const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  std::vector<std::string> names;
  for (const ValidationCaseDeck& one : deck.cases) names.push_back(one.name);
  for (const std::string& name : only) {
    if (is_in(names, name)) continue;
    throw DeckError(fmt::format("--case {}: {} has no such case, but {}", name, path, fmt::join(names, ", ")));
  }
  std::erase_if(deck.cases, [&](const ValidationCaseDeck& one) { return !is_in(only, one.name); });
}

/// The cases as runs of a plan, each with the figures it is compared by.
struct PlannedCases {
  CampaignPlan plan;
  std::vector<StudyRun> runs;
};

PlannedCases planned_cases(const ValidationDeck& deck, const RunRequest& request) {
  PlannedCases planned;
  for (std::size_t i = 0; i < deck.cases.size(); ++i) {
    const ValidationCaseDeck& one = deck.cases[i];
    planned.plan.bases.push_back(path_beside(request.deck, one.deck));
    planned.plan.experiments.push_back(one.name);
    for (const ComparisonDeck& c : one.comparisons) planned.plan.figures.push_back({c.figure, c.figure, i});
    StudyRun& run = planned.runs.emplace_back();
    run.name = one.name;
    run.overrides = overrides_of(one, request);
    run.experiment = i;
  }
  return planned;
}

}  // namespace

std::string validate_file(const Communicator& comm, const RunRequest& request, const std::vector<std::string>& only,
                          const StopAsked& stop_asked) {
  ValidationDeck deck = read_validation_deck(read_shared_file(comm, request.deck), request.deck);
  choose_cases(only, request.deck, deck);
  agree_after_root(comm, [&] {
    const PlannedCases planned = planned_cases(deck, request);
    check_campaign(planned.plan, planned.runs);
    create_output_directory(request.output);
    refuse_other_results(request.output, ResultsOf::validation);
  });
  Json cases = Json::array();
  for (const ValidationCaseDeck& one : deck.cases) cases.push_back(run_case(comm, one, request, stop_asked));
  std::string table;
  agree_after_root(comm, [&] {
    table = table_of(deck, cases);
    const Json all = {{"title", deck.title},
                      {"published", deck.published},
                      {"cases", cases},
                      {"build", json_of(build_info(to_string(request.level)))}};
    write_text_file(request.output + "/validation.json", json_text(all));
    write_text_file(request.output + "/validation.md", table);
  });
  return table;
}

std::string check_validation(const Communicator& comm, const RunRequest& request) {
  const ValidationDeck deck = read_validation_deck(read_shared_file(comm, request.deck), request.deck);
  std::string report;
  agree_after_root(comm, [&] {
    const PlannedCases planned = planned_cases(deck, request);
    report = planned_work_text(planned.plan, planned.runs, usual_core_speed, comm.size());
  });
  return report;
}

}  // namespace repose
