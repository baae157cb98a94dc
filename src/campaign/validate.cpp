#include "campaign/validate.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "campaign/figure_display.h"
#include "campaign/planned_work.h"
#include "comm/agreement.h"
#include "deck/read_deck.h"
#include "deck/resolved_deck.h"
#include "deck/validation_deck.h"
#include "files/atomic_file.h"
#include "files/directory.h"
#include "files/json_text.h"
#include "files/results_directory.h"
#include "files/shared_file.h"
#include "output/summary.h"
#include "run/finished_run.h"
#include "run/run_plan.h"
#include "run/summary_figures.h"

namespace repose {
namespace {

using Json = nlohmann::ordered_json;

Json comparison_json(const ComparisonDeck& c, const Json& summary) {
  return {{"figure", c.figure},
          {"here", json_number(figure_in(summary, c.figure))},
          {"error", json_number(error_in(summary, c.figure))},
          {"laboratory", c.laboratory},
          {"deviation", json_number(c.deviation)},
          {"published", json_number(c.published)}};
}

std::string cell(const Json& value, const Json& error, const FigureDisplay& display) {
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
      const FigureDisplay display = display_of(c["figure"].get<std::string>());
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

RunRequest run_of_case(const ValidationCaseDeck& one, const RunRequest& request) {
  RunRequest run = request;
  run.deck = path_beside(request.deck, one.deck);
  run.overrides = overrides_of(one, request);
  run.output = fmt::format("{}/{}", request.output, one.name);
  run.restart = true;
  return run;
}

/// Collective. Whether there are complete results of the case as it is now, with all that is compared.
bool is_done(const Communicator& comm, const ValidationCaseDeck& one, const RunRequest& run) {
  try {
    const Deck deck = read_deck(read_shared_file(comm, run.deck), run.deck, run.overrides);
    for (const ComparisonDeck& c : one.comparisons) require_figure(deck, c.figure);
    return is_finished(comm, run.output, resolved_deck(deck));
  } catch (const Error&) {  // on all ranks alike: the case is wrong, or its results are damaged or of another deck
    return false;
  }
}

/// Collective. A case whose results are complete beside the laboratory.
Json compared(const Communicator& comm, const ValidationCaseDeck& one, const std::string& directory) {
  Json result;
  agree_after_root(comm, [&] {
    const Json summary = Json::parse(read_whole_file(directory + "/summary.json"));
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

bool is_in(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Of the deck the cases with these names, if any are given.
ValidationDeck chosen_cases(const std::vector<std::string>& only, const std::string& path, ValidationDeck deck) {
  if (only.empty()) return deck;
  std::vector<std::string> names;
  for (const ValidationCaseDeck& one : deck.cases) names.push_back(one.name);
  for (const std::string& name : only) {
    if (is_in(names, name)) continue;
    throw DeckError(fmt::format("--case {}: {} has no such case, but {}", name, path, fmt::join(names, ", ")));
  }
  std::erase_if(deck.cases, [&](const ValidationCaseDeck& one) { return !is_in(only, one.name); });
  return deck;
}

/// Collective. Runs the chosen cases, unless that is done already, and compares them and those others whose results are
/// complete.
Json compared_cases(const Communicator& comm, const ValidationDeck& deck, const std::vector<std::string>& only,
                    const RunRequest& request, const StopAsked& stop_asked) {
  Json cases = Json::array();
  for (const ValidationCaseDeck& one : deck.cases) {
    const RunRequest run = run_of_case(one, request);
    if (only.empty() || is_in(only, one.name)) {
      if (comm.is_root()) request.log.say("case " + one.name);
      run_file(comm, run, stop_asked);
    } else if (!is_done(comm, one, run)) {
      continue;
    }
    cases.push_back(compared(comm, one, run.output));
  }
  return cases;
}

/// The cases as runs of a plan, each with the figures it is compared by.
struct PlannedCases {
  CampaignPlan plan;
  std::vector<StudyRun> runs;
};

PlannedCases planned_cases(const ValidationDeck& deck, const std::string& text, const RunRequest& request) {
  PlannedCases planned;
  planned.plan.deck = request.deck;
  planned.plan.deck_text = text;
  planned.plan.command_line = request.overrides;
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
  const std::string text = read_shared_file(comm, request.deck);
  const ValidationDeck deck = read_validation_deck(text, request.deck);
  const ValidationDeck chosen = chosen_cases(only, request.deck, deck);
  agree_after_root(comm, [&] {
    const PlannedCases planned = planned_cases(chosen, text, request);
    check_campaign(planned.plan, planned.runs);
    create_output_directory(request.output);
    refuse_other_results(request.output, ResultsOf::validation);
  });
  const Json cases = compared_cases(comm, deck, only, request, stop_asked);
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
  const std::string text = read_shared_file(comm, request.deck);
  const ValidationDeck deck = read_validation_deck(text, request.deck);
  std::string report;
  agree_after_root(comm, [&] {
    const PlannedCases planned = planned_cases(deck, text, request);
    report = planned_work_text(planned.plan, planned.runs, usual_core_speed, comm.size());
  });
  return report;
}

}  // namespace repose
