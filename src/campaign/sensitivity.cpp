#include "campaign/sensitivity.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "calibration/morris.h"
#include "calibration/one_at_a_time.h"
#include "campaign/campaign.h"
#include "campaign/observables.h"
#include "campaign/planned_work.h"
#include "comm/agreement.h"
#include "deck/sensitivity_deck.h"
#include "files/atomic_file.h"
#include "files/json_text.h"
#include "files/results_directory.h"
#include "files/shared_file.h"
#include "run/run_plan.h"

namespace repose {
namespace {

using Json = nlohmann::ordered_json;
using Points = std::vector<std::vector<double>>;

constexpr std::uint64_t design_seed = 1;

/// Each parameter at its lower and its upper value, the others at their fixed ones.
Points one_at_a_time_points(const StudyDeck& study) {
  std::vector<double> fixed;
  for (const ParameterDeck& p : study.parameters) fixed.push_back(p.fixed);
  Points points;
  for (std::size_t k = 0; k < study.parameters.size(); ++k) {
    for (const double end : {study.parameters[k].min, study.parameters[k].max}) {
      points.push_back(fixed);
      points.back()[k] = end;
    }
  }
  return points;
}

/// Adds to `all` what is not there yet. Where each of `points` is.
std::vector<std::size_t> join(const Points& points, Points& all) {
  std::vector<std::size_t> places;
  for (const std::vector<double>& point : points) {
    const auto found = std::find(all.begin(), all.end(), point);
    places.push_back(static_cast<std::size_t>(found - all.begin()));
    if (found == all.end()) all.push_back(point);
  }
  return places;
}

std::string shown(double value) { return std::isfinite(value) ? fmt::format("{:.4g}", value) : std::string("none"); }

Json sample_json(const SeedSample& s) {
  return {{"mean", json_number(s.mean)}, {"deviation", json_number(s.deviation)}, {"runs", s.runs}};
}

/// The runs of a study, point after point, and their values of a figure.
struct Results {
  const StudyDeck& study;
  std::vector<double> values;

  std::span<const double> at(std::size_t point) const {
    const auto seeds = static_cast<std::size_t>(study.seeds);
    return std::span(values).subspan(point * seeds, seeds);
  }
};

void add_one_at_a_time(const Results& results, std::span<const std::size_t> places, const std::string& figure,
                       Json& json, std::string& text) {
  for (std::size_t k = 0; k < results.study.parameters.size(); ++k) {
    const ParameterDeck& p = results.study.parameters[k];
    const OneAtATimeEffect e = one_at_a_time_effect(results.at(places[2 * k]), results.at(places[2 * k + 1]));
    json.push_back({{"figure", figure},
                    {"parameter", p.name},
                    {"lower", sample_json(e.lower)},
                    {"upper", sample_json(e.upper)},
                    {"effect", json_number(e.effect)},
                    {"standard_error", json_number(e.standard_error)}});
    text += fmt::format("| {} | {} | {} | {} | {} +- {} |\n", figure, p.name, shown(e.lower.mean), shown(e.upper.mean),
                        shown(e.effect), shown(e.standard_error));
  }
}

void add_morris(const Results& results, const Points& points, std::span<const std::size_t> places,
                const std::string& figure, Json& json, std::string& text) {
  std::vector<double> means;
  for (const std::size_t place : places) means.push_back(seed_sample(results.at(place)).mean);
  const std::vector<MorrisEffect> effects = morris_effects(ranges_of(results.study), points, means);
  for (std::size_t k = 0; k < effects.size(); ++k) {
    const MorrisEffect& e = effects[k];
    const std::string& name = results.study.parameters[k].name;
    json.push_back({{"figure", figure},
                    {"parameter", name},
                    {"mu", json_number(e.mean)},
                    {"mu_star", json_number(e.mean_absolute)},
                    {"sigma", json_number(e.deviation)},
                    {"mu_error", json_number(e.mean_error)},
                    {"mu_star_error", json_number(e.mean_absolute_error)},
                    {"effects", e.effects}});
    text += fmt::format("| {} | {} | {} +- {} | {} | {} |\n", figure, name, shown(e.mean_absolute),
                        shown(e.mean_absolute_error), shown(e.mean), shown(e.deviation));
  }
}

/// The points of both designs, each once.
struct Design {
  explicit Design(const SensitivityDeck& deck) {
    ends = join(one_at_a_time_points(deck.study), all);
    if (deck.morris.enabled) {
      walks = morris_design(ranges_of(deck.study), static_cast<std::size_t>(deck.morris.trajectories),
                            static_cast<std::size_t>(deck.morris.levels), design_seed);
    }
    steps = join(walks, all);
  }
  Points all;
  Points walks;                    ///< of Morris
  std::vector<std::size_t> ends;   ///< in `all`: lower and upper of each parameter
  std::vector<std::size_t> steps;  ///< in `all`: of the walks
};

CampaignPlan plan_of_figures(const SensitivityDeck& deck, const std::string& text, const RunRequest& request) {
  std::vector<RunFigure> figures;
  for (const std::string& figure : deck.figures) figures.push_back({figure, figure});
  return plan_of(deck.study, figures, text, request);
}

struct Effects {
  std::string json;
  std::string text;
};

Effects effects_of(const SensitivityDeck& deck, const Design& design, std::span<const RunRecord> records) {
  Json one_at_a_time = Json::array();
  Json screening = Json::array();
  std::string text = "| figure | parameter | at the lower value | at the upper | effect |\n|---|---|---|---|---|\n";
  std::string morris = "\n| figure | parameter | mu* over the range | mu | sigma |\n|---|---|---|---|---|\n";
  for (std::size_t f = 0; f < deck.figures.size(); ++f) {
    const Results results{deck.study, values_of_figure(records, deck.figures[f], f)};
    add_one_at_a_time(results, design.ends, deck.figures[f], one_at_a_time, text);
    if (deck.morris.enabled) add_morris(results, design.walks, design.steps, deck.figures[f], screening, morris);
  }
  Json parameters = Json::array();
  for (const ParameterDeck& p : deck.study.parameters) {
    parameters.push_back({{"name", p.name}, {"key", p.key}, {"min", p.min}, {"max", p.max}, {"fixed", p.fixed}});
  }
  const Json json = {{"title", deck.study.title},
                     {"seeds", deck.study.seeds},
                     {"parameters", parameters},
                     {"one_at_a_time", one_at_a_time},
                     {"morris", screening}};
  return {json_text(json, 1), deck.morris.enabled ? text + morris : text};
}

}  // namespace

std::string check_sensitivity(const Communicator& world, const RunRequest& request) {
  const std::string text = read_shared_file(world, request.deck);
  const SensitivityDeck deck = read_sensitivity_deck(text, request.deck);
  const CampaignPlan plan = plan_of_figures(deck, text, request);
  std::string report;
  agree_after_root(world, [&] {
    const std::vector<StudyRun> runs = runs_at(plan.study, Design(deck).all);
    report = planned_work_text(plan, runs, usual_core_speed, world.size());
  });
  return report;
}

std::string sensitivity_file(const Communicator& world, const RunRequest& request, const StopAsked& stop_asked) {
  const std::string text = read_shared_file(world, request.deck);
  const SensitivityDeck deck = read_sensitivity_deck(text, request.deck);
  const CampaignPlan plan = plan_of_figures(deck, text, request);
  const Design design(deck);
  const std::vector<StudyRun> runs = runs_at(plan.study, design.all);
  const ResultsDirectory directory(world, request.output, ResultsOf::sensitivity);
  agree_after_root(world, [&] {
    check_campaign(plan, runs);
    write_text_file(request.output + "/sensitivity.toml", copy_of_study(text, request));
  });
  CampaignEffort effort;
  const std::vector<RunRecord> records = run_campaign(world, plan, runs, stop_asked, effort);
  std::string report;
  agree_after_root(world, [&] {
    const Effects effects = effects_of(deck, design, records);
    write_text_file(request.output + "/sensitivity.json", effects.json);
    report = effects.text + effort_text(effort, world.size());
  });
  return report;
}

}  // namespace repose
