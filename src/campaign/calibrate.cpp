#include "campaign/calibrate.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "calibration/acquisition.h"
#include "calibration/start_design.h"
#include "campaign/campaign.h"
#include "campaign/estimate_report.h"
#include "campaign/observables.h"
#include "comm/agreement.h"
#include "deck/calibration_deck.h"
#include "files/atomic_file.h"
#include "files/directory.h"
#include "files/shared_file.h"

namespace repose {
namespace {

using Points = std::vector<std::vector<double>>;

constexpr const char* deck_file = "/calibration.toml";
constexpr const char* estimate_file = "/estimate.json";

std::vector<std::string> figures_of(const CalibrationDeck& deck) {
  std::vector<std::string> figures;
  for (const ObservableDeck& o : deck.observables) figures.push_back(o.figure);
  return figures;
}

/// Before any run: whether there can be an estimate afterwards.
void check_counts(const CalibrationDeck& deck, const std::string& path) {
  const std::size_t parameters = deck.study.parameters.size();
  if (parameters > 3)
    throw DeckError(fmt::format("{}: {} parameters; at most 3 can be estimated together", path, parameters));
  if (deck.observables.size() >= parameters) return;
  throw DeckError(fmt::format("{}: {} parameters take as many [[observable]]s or more, there are {}", path, parameters,
                              deck.observables.size()));
}

/// Six digits are more than a run can tell, and names of folders stay short.
Points rounded(Points points) {
  for (std::vector<double>& point : points) {
    for (double& value : point) value = std::stod(fmt::format("{:.6g}", value));
  }
  return points;
}

/// Collective. The points of rank 0 on all ranks.
void broadcast(const Communicator& world, Points& points, std::size_t parameters) {
  std::vector<double> values;
  for (const std::vector<double>& point : points) values.insert(values.end(), point.begin(), point.end());
  world.broadcast(values);
  points.clear();
  for (auto at = values.begin(); at != values.end(); at += static_cast<std::ptrdiff_t>(parameters)) {
    points.emplace_back(at, at + static_cast<std::ptrdiff_t>(parameters));
  }
}

struct DoneRuns {
  std::vector<StudyRun> runs;
  std::vector<RunRecord> records;  ///< on rank 0
};

/// Does the runs at all points so far.
struct Work {
  const Communicator& world;
  const CampaignPlan& plan;
  const StopAsked& stop_asked;
  CampaignEffort effort{};

  DoneRuns at(const Points& points) {
    std::vector<StudyRun> runs = runs_at(plan.study, points);
    agree_after_root(world, [&] { check_campaign(plan, runs); });
    CampaignEffort now;
    std::vector<RunRecord> records = run_campaign(world, plan, runs, stop_asked, now);
    const double before = effort.wall_seconds * effort.idle_share;
    effort.wall_seconds += now.wall_seconds;
    if (effort.wall_seconds > 0.0) {
      effort.idle_share = (before + now.wall_seconds * now.idle_share) / effort.wall_seconds;
    }
    effort.runs += now.runs;
    effort.groups = std::max(effort.groups, now.groups);
    return {std::move(runs), std::move(records)};
  }
};

/// Collective. Points decided batch after batch, each from the complete batches before alone: so neither ranks nor
/// timing can change them. Ends when two estimates in a row are narrow enough, or at the budget.
DoneRuns search(const CalibrationDeck& deck, Work& work) {
  constexpr std::uint64_t design_seed = 1;
  const AdaptiveDeck& a = deck.adaptive;
  const std::vector<ParameterRange> ranges = ranges_of(deck.study);
  Points points = rounded(start_design(ranges, static_cast<std::size_t>(a.start), design_seed));
  int narrow = 0;
  while (true) {
    DoneRuns done = work.at(points);
    Points more;
    agree_after_root(work.world, [&] {
      const Misfit misfit(ranges, places_of(done.runs), observable_data(deck, done.records));
      const Estimate now = estimate(misfit, deck.confidence);
      narrow = now.half_width && *now.half_width <= a.half_width ? narrow + 1 : 0;
      work.plan.log.say(fmt::format("{} points: {}", points.size(), progress_of(now)));
      const auto left = static_cast<std::size_t>(a.budget) - points.size();
      if (narrow >= 2 || left == 0) return;
      more = rounded(next_points(misfit, now, std::min(static_cast<std::size_t>(a.batch), left),
                                 static_cast<std::size_t>(deck.study.seeds)));
    });
    broadcast(work.world, more, ranges.size());
    if (more.empty()) return done;
    points.insert(points.end(), more.begin(), more.end());
  }
}

std::string write_estimate(const CalibrationDeck& deck, std::span<const StudyRun> runs,
                           std::span<const RunRecord> records, const std::string& directory) {
  const Report report = report_of(deck, runs, records);
  write_text_file(directory + estimate_file, report.json);
  return report.text;
}

}  // namespace

std::string calibrate_file(const Communicator& world, const RunRequest& request, const StopAsked& stop_asked) {
  const std::string text = read_shared_file(world, request.deck);
  const CalibrationDeck deck = read_calibration_deck(text, request.deck);
  check_counts(deck, request.deck);
  const CampaignPlan plan = plan_of(deck.study, figures_of(deck), text, request);
  agree_after_root(world, [&] {
    create_output_directory(request.output);
    write_text_file(request.output + deck_file, text);
  });
  Work work{world, plan, stop_asked};
  const auto done = deck.adaptive.enabled ? search(deck, work) : work.at(points_of(deck));
  std::string report;
  agree_after_root(world, [&] {
    report = write_estimate(deck, done.runs, done.records, request.output);
    report += effort_text(work.effort, world.size());
  });
  return report;
}

std::string estimate_directory(const Communicator& world, const std::string& directory, const std::string& path) {
  const std::string deck_path = path.empty() ? directory + deck_file : path;
  const CalibrationDeck deck = read_calibration_deck(read_shared_file(world, deck_path), deck_path);
  std::string report;
  agree_after_root(world, [&] {
    const std::vector<std::string> figures = figures_of(deck);
    const std::vector<StudyRun> runs = runs_in(directory + "/runs", deck.study);
    const std::vector<RunRecord> records = read_run_folders(directory, runs, figures);
    report = write_estimate(deck, runs, records, directory);
  });
  return report;
}

}  // namespace repose
