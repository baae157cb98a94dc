#include "campaign/calibrate.h"

#include <optional>

#include <fmt/core.h>

#include "base/error.h"
#include "calibration/posterior_estimate.h"
#include "campaign/calibration_work.h"
#include "campaign/curve_observables.h"
#include "campaign/estimate_report.h"
#include "campaign/level_runs.h"
#include "campaign/live_report.h"
#include "campaign/observables.h"
#include "campaign/search.h"
#include "comm/agreement.h"
#include "deck/calibration_deck.h"
#include "files/atomic_file.h"
#include "files/directory.h"
#include "files/shared_file.h"

namespace repose {
namespace {

constexpr const char* deck_file = "/calibration.toml";
constexpr const char* estimate_file = "/estimate.json";
constexpr const char* samples_file = "/posterior.csv";

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

/// Before any run: whether there can be an estimate afterwards.
void check_counts(const CalibrationDeck& deck, const std::string& path) {
  const std::size_t parameters = deck.study.parameters.size();
  if (parameters > most_parameters) {
    throw DeckError(
        fmt::format("{}: {} parameters; at most {} can be estimated together", path, parameters, most_parameters));
  }
  std::int64_t observables = 0;
  for (const ObservableDeck& o : deck.observables) observables += o.is_curve() ? o.components : 1;
  if (takes_posterior(ranges_of(deck.study)) || observables >= static_cast<std::int64_t>(parameters)) return;
  throw DeckError(
      fmt::format("{}: {} parameters take as many [[observable]]s or more, there are {}; fewer do with a "
                  "\"prior\" of a parameter",
                  path, parameters, observables));
}

std::string write_estimate(const Projection& projection, std::span<const StudyRun> runs, const std::string& directory) {
  const Report report = report_of(projection, runs);
  if (!report.samples.empty()) write_text_file(directory + samples_file, report.samples);
  write_text_file(directory + estimate_file, report.json);
  return report.text;
}

}  // namespace

std::string calibrate_file(const Communicator& world, const RunRequest& request, const StopAsked& stop_asked,
                           const std::string& report_file) {
  const std::string text = read_shared_file(world, request.deck);
  CalibrationDeck deck = read_calibration_deck(text, request.deck);
  check_counts(deck, request.deck);
  check_priors_in_ranges(deck, request.deck);
  const auto path_of = [&](const ObservableDeck& o) { return path_beside(request.deck, o.curve); };
  read_curves(world, path_of, deck);
  std::optional<LiveReport> live;
  agree_after_root(world, [&] {
    create_output_directory(request.output);
    write_text_file(request.output + deck_file, text);
    for (const ObservableDeck& o : deck.observables) {
      if (o.is_curve()) write_text_file(request.output + "/" + curve_copy(o), read_whole_file(path_of(o)));
    }
    if (!report_file.empty()) live.emplace(request.output, report_file, request.log);
  });
  CalibrationWork work(world, deck, text, request, stop_asked, live ? &*live : nullptr);
  const auto done = deck.adaptive.enabled ? search(deck, work) : work.at(at_every_level(deck, points_of(deck)));
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
    const std::vector<StudyRun> runs = level_runs_in(directory + "/runs", deck);
    const std::vector<RunRecord> records = read_run_folders(directory, runs, run_figures(deck));
    report = write_estimate(project_curves(deck, directory, runs, records), runs, directory);
  });
  return report;
}

}  // namespace repose
