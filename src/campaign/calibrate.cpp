#include "campaign/calibrate.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include "base/error.h"
#include "calibration/posterior_estimate.h"
#include "calibration/standard_runs.h"
#include "campaign/calibration_work.h"
#include "campaign/curve_observables.h"
#include "campaign/estimate_report.h"
#include "campaign/level_report.h"
#include "campaign/level_runs.h"
#include "campaign/live_report.h"
#include "campaign/observables.h"
#include "campaign/search.h"
#include "comm/agreement.h"
#include "deck/calibration_deck.h"
#include "deck/deck_difference.h"
#include "files/atomic_file.h"
#include "files/results_directory.h"
#include "files/shared_file.h"

namespace repose {
namespace {

constexpr const char* deck_file = "/calibration.toml";
constexpr const char* estimate_file = "/estimate.json";
constexpr const char* samples_file = "/posterior.csv";
constexpr const char* resolved_file = "/deck.resolved.toml";

/// A prior of which the range leaves next to nothing is a mistake.
void check_priors_in_ranges(const CalibrationDeck& deck, const std::string& path) {
  constexpr double least = 0.01;
  for (const ParameterRange& range : ranges_of(deck.study)) {
    const double share = prior_in_range(range);
    if (share >= least) continue;
    throw DeckError(
        fmt::format("{}: parameter \"{}\": {:.2g} of its prior lies from min = {} to max = {}; at least {} "
                    "must",
                    path, range.name, share, range.lower, range.upper, least));
  }
}

/// DeckError when a parameter is the same at all points: the runs can say nothing of it.
void require_variation(const StudyDeck& study, std::span<const std::vector<double>> points, const std::string& path) {
  for (std::size_t k = 0; k < study.parameters.size(); ++k) {
    const auto is_the_same = [&](const std::vector<double>& point) { return point[k] == points.front()[k]; };
    if (points.empty() || !std::all_of(points.begin(), points.end(), is_the_same)) continue;
    throw DeckError(fmt::format("{}: parameter \"{}\" is {} at all points; to estimate it takes two values or more",
                                path, study.parameters[k].name, points.front()[k]));
  }
}

/// Before any run: whether there can be an estimate afterwards.
void check_counts(const CalibrationDeck& deck, const std::string& path) {
  const std::size_t parameters = deck.study.parameters.size();
  if (parameters > most_parameters) {
    throw DeckError(
        fmt::format("{}: {} parameters; at most {} can be estimated together", path, parameters, most_parameters));
  }
  const std::vector<std::vector<double>> points = points_of(deck);
  if (!deck.adaptive.enabled && std::ssize(points) < least_points) {
    throw DeckError(fmt::format("{}: {} points; a surface needs {} or more", path, points.size(), least_points));
  }
  require_variation(deck.study, points, path);
  std::int64_t observables = 0;
  for (const ObservableDeck& o : deck.observables) observables += o.is_curve() ? o.components : 1;
  if (takes_posterior(ranges_of(deck.study)) || observables >= static_cast<std::int64_t>(parameters)) return;
  throw DeckError(
      fmt::format("{}: {} parameters take as many [[observable]]s or more, there are {}; fewer do with a "
                  "\"prior\" of a parameter",
                  path, parameters, observables));
}

/// Collective. What a calibration is to find, with its curves, as far as it can be right before any run.
CalibrationDeck read_deck_and_curves(const Communicator& world, const std::string& text, const std::string& path) {
  CalibrationDeck deck = read_calibration_deck(text, path);
  check_counts(deck, path);
  check_priors_in_ranges(deck, path);
  read_curves(
      world, [&](const ObservableDeck& o) { return path_beside(path, o.curve); }, deck);
  return deck;
}

/// The points that are run before any estimate.
std::vector<LevelPoint> first_points(const CalibrationDeck& deck) {
  return deck.adaptive.enabled ? first_design(deck) : at_every_level(deck, points_of(deck));
}

/// How a search goes on after its first design.
std::string search_text(const AdaptiveDeck& a) {
  std::string text = fmt::format("search      then {} points at a time until the region is narrow", a.batch);
  if (a.budget > 0) text += fmt::format(", at most {} points", a.budget);
  if (!std::isnan(a.budget_core_hours)) text += fmt::format(", at most {:g} core-hours", a.budget_core_hours);
  return text + " in all\n";
}

/// What `repose estimate` reads in the directory.
void write_copies(const CalibrationDeck& deck, const std::string& text, const RunRequest& request) {
  write_text_file(request.output + deck_file, copy_of_study(text, request));
  for (const ObservableDeck& o : deck.observables) {
    if (!o.is_curve()) continue;
    write_text_file(request.output + "/" + curve_copy(o), read_whole_file(path_beside(request.deck, o.curve)));
  }
}

std::string write_estimate(const Projection& projection, std::span<const StudyRun> runs, const std::string& directory) {
  const Report report = report_of(projection, runs);
  if (report.samples.empty()) {
    std::filesystem::remove(directory + samples_file);  // of an estimate with priors
  } else {
    write_text_file(directory + samples_file, report.samples);
  }
  write_text_file(directory + estimate_file, report.json);
  return report.text;
}

/// Those of points beyond the ranges of the parameters; a line on how many, if any.
std::string leave_out_beyond_ranges(const StudyDeck& study, std::vector<StudyRun>& runs) {
  const std::vector<ParameterRange> ranges = ranges_of(study);
  const auto is_beyond = [&](const StudyRun& run) {
    for (std::size_t j = 0; j < ranges.size(); ++j) {
      const double slack = 1e-9 * (ranges[j].upper - ranges[j].lower);
      if (run.values[j] < ranges[j].lower - slack || run.values[j] > ranges[j].upper + slack) return true;
    }
    return false;
  };
  const std::size_t left_out = std::erase_if(runs, is_beyond);
  if (left_out == 0) return "";
  return fmt::format("runs beyond the ranges of the parameters are left out: {}\n", left_out);
}

/// DeckError when runs of one level and experiment that have begun differ by more than their parameters and seeds and
/// how they are written.
void refuse_mixed_decks(const std::string& directory, std::span<const StudyRun> runs) {
  struct Begun {
    std::string name, deck;
  };
  std::map<std::pair<std::size_t, std::size_t>, Begun> first_of;
  for (const StudyRun& run : runs) {
    const std::string path = folder_of(directory, run) + resolved_file;
    if (!std::filesystem::exists(path)) continue;
    const Begun own{run.name, read_whole_file(path)};
    const auto [found, is_first] = first_of.try_emplace({run.level, run.experiment}, own);
    if (is_first) continue;
    const Begun& first = found->second;
    const std::span varied = std::span(run.overrides).last(run.values.size() + 1);  // and the seed
    for (const DeckDifference& d : deck_differences_beyond({varied.begin(), varied.end()}, first.deck, own.deck)) {
      if (d.key.starts_with("output.")) continue;
      throw DeckError(fmt::format(
          "{}/runs: {} and {} are of different decks: {}: {} in the one, {} in the other; an estimate takes "
          "runs of one deck, so move those of the other away",
          directory, first.name, own.name, d.key, value_or_nothing(d.before), value_or_nothing(d.now)));
    }
  }
}

}  // namespace

std::string calibrate_file(const Communicator& world, const RunRequest& request, const StopAsked& stop_asked,
                           const std::string& report_file) {
  const std::string text = read_shared_file(world, request.deck);
  const CalibrationDeck deck = read_deck_and_curves(world, text, request.deck);
  const ResultsDirectory directory(world, request.output, ResultsOf::calibration);
  CalibrationWork work(world, deck, text, request, stop_asked);
  const std::vector<LevelPoint> first = first_points(deck);
  std::optional<LiveReport> live;
  agree_after_root(world, [&] {
    work.check(first);
    write_copies(deck, text, request);
    if (!report_file.empty()) work.renew(live.emplace(request.output, report_file, request.log));
  });
  const DoneRuns done = deck.adaptive.enabled ? search(deck, work, first) : work.at(first);
  std::string report;
  agree_after_root(world, [&] {
    const Projection projection = project_curves(deck, request.output, done.runs, done.records);
    work.write_table(projection, done.runs);
    report = write_estimate(projection, done.runs, request.output);
    report += effort_text(work.effort(), world.size());
    if (live) live->finish();
  });
  return report;
}

std::string check_calibration(const Communicator& world, const RunRequest& request) {
  const std::string text = read_shared_file(world, request.deck);
  const CalibrationDeck deck = read_deck_and_curves(world, text, request.deck);
  const CalibrationWork work(world, deck, text, request, {});
  std::string report;
  agree_after_root(world, [&] {
    report = work.planned(first_points(deck));
    if (deck.adaptive.enabled) report += search_text(deck.adaptive);
  });
  return report;
}

std::string estimate_directory(const Communicator& world, const std::string& directory, const std::string& path) {
  const std::string deck_path = path.empty() ? directory + deck_file : path;
  CalibrationDeck deck = read_calibration_deck(read_shared_file(world, deck_path), deck_path);
  read_curves(
      world,
      [&](const ObservableDeck& o) {
        return path.empty() ? directory + "/" + curve_copy(o) : path_beside(deck_path, o.curve);
      },
      deck);
  check_priors_in_ranges(deck, deck_path);
  std::string report;
  agree_after_root(world, [&] {
    std::vector<StudyRun> runs = level_runs_in(directory + "/runs", deck);
    report = leave_out_beyond_ranges(deck.study, runs);
    refuse_mixed_decks(directory, runs);
    const std::vector<RunRecord> records = read_run_folders(directory, runs, run_figures(deck));
    const KnownLevels known = known_levels(deck, runs, records);
    require_variation(deck.study, places_of(known.runs), deck_path);
    const Projection projection = project_curves(known.deck, directory, known.runs, known.records);
    report += known.left_out + write_estimate(projection, known.runs, directory);
  });
  return report;
}

}  // namespace repose
