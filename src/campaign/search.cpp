#include "campaign/search.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "base/error.h"
#include "calibration/start_design.h"
#include "campaign/estimate_report.h"
#include "campaign/expected_cost.h"
#include "campaign/level_report.h"
#include "campaign/observables.h"
#include "comm/agreement.h"
#include "files/atomic_file.h"

namespace repose {
namespace {

using Points = std::vector<LevelPoint>;

constexpr double seconds_per_hour = 3600.0;
constexpr std::uint64_t design_seed = 1;

/// Six digits are more than a run can tell, and names of folders stay short.
Points rounded(Points points) {
  for (LevelPoint& point : points) {
    for (double& value : point.values) value = std::stod(fmt::format("{:.6g}", value));
  }
  return points;
}

/// Collective. The points of rank 0 on all ranks.
void broadcast(const Communicator& world, Points& points, std::size_t parameters) {
  std::vector<double> values;
  for (const LevelPoint& point : points) {
    values.push_back(static_cast<double>(point.level));
    values.insert(values.end(), point.values.begin(), point.values.end());
  }
  world.broadcast(values);
  points.clear();
  const auto width = static_cast<std::ptrdiff_t>(parameters);
  for (auto at = values.begin(); at != values.end(); at += 1 + width) {
    points.push_back({static_cast<std::size_t>(*at), {at + 1, at + 1 + width}});
  }
}

/// What the next batch may be, after these runs.
BatchPlan batch_after(const CalibrationDeck& deck, const DoneRuns& done, std::size_t points) {
  const AdaptiveDeck& a = deck.adaptive;
  BatchPlan batch;
  batch.points = static_cast<std::size_t>(a.batch);
  if (a.budget > 0) batch.points = std::min(batch.points, static_cast<std::size_t>(a.budget) - points);
  for (std::size_t e = 0; e < deck.experiment_count(); ++e) {
    for (std::size_t level = 0; level < deck.level_count(); ++level) {
      batch.seeds.push_back(static_cast<std::size_t>(study_of_level(deck, level, e).seeds));
    }
  }
  batch.cost = [](const LevelPoint&) { return 1.0; };
  const bool in_core_hours = !std::isnan(a.budget_core_hours);
  if (deck.levels.empty() && !in_core_hours) return batch;
  batch.cost = [&deck, &done](const LevelPoint& point) {
    double steps = 0.0;
    for (std::size_t e = 0; e < deck.experiment_count(); ++e) {
      steps += static_cast<double>(study_of_level(deck, point.level, e).seeds) *
               expected_particle_steps(done.runs, done.records, deck.study.parameters, point.level, e, point.values);
    }
    return steps / (deck.adaptive.core_speed * seconds_per_hour);
  };
  if (in_core_hours) batch.budget = a.budget_core_hours - core_hours(deck, done.runs, done.records);
  return batch;
}

/// Throws what kept a run from its end: decided without it, a batch would be another one than with it.
void require_ended(const DoneRuns& done) {
  for (std::size_t i = 0; i < done.runs.size(); ++i) {
    const RunRecord& record = done.records[i];
    if (record.state != RunState::waiting) continue;
    const std::string run = "runs/" + done.runs[i].name;
    if (record.failure == ExitCode::usage) {
      throw DeckError(fmt::format("{}: {}; change the ranges of the parameters, or the deck, so that it can be set up",
                                  run, record.reason));
    }
    throw FileError(fmt::format("{}: {}; the search goes on when the same command has done this run", run,
                                record.reason.empty() ? "has not come to its end" : record.reason));
  }
}

/// A row of search.csv after each batch; an empty field for no region.
std::string row_of(const CalibrationDeck& deck, const DoneRuns& done, std::size_t points, const Estimate& now) {
  return fmt::format("{},{},{},{}\n", points, done.runs.size(), core_hours(deck, done.runs, done.records),
                     now.half_width ? fmt::format("{}", *now.half_width) : std::string());
}

std::string counts_of(const CalibrationDeck& deck, const Points& points) {
  if (deck.levels.empty()) return fmt::format("{} points", points.size());
  std::string text;
  for (std::size_t level = 0; level < deck.levels.size(); ++level) {
    const auto count = std::count_if(points.begin(), points.end(), [&](const auto& p) { return p.level == level; });
    text += fmt::format("{}{} {}", level == 0 ? "" : ", ", count, deck.levels[level].name);
  }
  return text + " points";
}

/// Whether runs at further points can mend that an observable has too few: some have come to their ends, and a budget
/// ends the search.
bool can_go_on(const CalibrationDeck& deck, const DoneRuns& done, std::size_t level) {
  for (std::size_t i = 0; i < done.runs.size(); ++i) {
    if (done.runs[i].level != level || !is_complete(done.records[i].state)) continue;
    return deck.adaptive.budget > 0 ||
           (!std::isnan(deck.adaptive.budget_core_hours) && done.records[i].particle_steps > 0.0);
  }
  return false;
}

/// Points of a level that fill the space between those it has.
Points filling(const CalibrationDeck& deck, const Points& points, std::size_t level, const BatchPlan& batch) {
  std::vector<std::vector<double>> known;
  for (const LevelPoint& point : points) {
    if (point.level == level) known.push_back(point.values);
  }
  Points chosen;
  double left = batch.budget;
  for (std::vector<double>& values : points_between(ranges_of(deck.study), known, batch.points, design_seed)) {
    LevelPoint& point = chosen.emplace_back(LevelPoint{level, std::move(values)});
    left -= batch.cost(point);
    if (left >= 0.0) continue;
    chosen.pop_back();
    break;
  }
  return chosen;
}

}  // namespace

double core_hours(const CalibrationDeck& deck, std::span<const StudyRun> runs, std::span<const RunRecord> records) {
  double sum = 0.0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    sum += records[i].particle_steps;
    if (records[i].state != RunState::failed) continue;
    sum += expected_particle_steps(runs, records, deck.study.parameters, runs[i].level, runs[i].experiment,
                                   runs[i].values);
  }
  return sum / (deck.adaptive.core_speed * seconds_per_hour);
}

std::vector<LevelPoint> first_design(const CalibrationDeck& deck) {
  const std::vector<ParameterRange> ranges = ranges_of(deck.study);
  Points points;
  for (std::size_t level = 0; level < deck.level_count(); ++level) {
    const auto count = static_cast<std::size_t>(start_of_level(deck, level));
    std::vector<std::vector<double>> design = start_design(ranges, count, design_seed);
    for (std::vector<double>& values : points_of_level(deck, level)) design.push_back(std::move(values));
    for (std::vector<double>& values : design) points.push_back({level, std::move(values)});
  }
  return rounded(std::move(points));
}

DoneRuns search(const CalibrationDeck& deck, CalibrationWork& work, Points points) {
  std::string history = "points,runs,core_hours,half_width\n";
  int narrow = 0;
  while (true) {
    DoneRuns done = work.at(points);
    Points more;
    agree_after_root(work.world(), [&] {
      require_ended(done);
      const Projection now_known = project_curves(deck, work.directory(), done.runs, done.records);
      const BatchPlan batch = batch_after(deck, done, points.size());
      const auto lacks = too_few_points(now_known.deck, done.runs, now_known.records, 0, deck.level_count() - 1);
      if (lacks && can_go_on(deck, done, lacks->level)) {
        narrow = 0;
        work.log().say(fmt::format("{}: no estimate yet; {}", counts_of(deck, points), lacks->with_level));
        history += row_of(deck, done, points.size(), {});
        write_text_file(work.directory() + "/search.csv", history);
        more = rounded(filling(deck, points, lacks->level, batch));
        return;
      }
      require_surfaces(now_known.deck, done.runs, now_known.records);
      const Misfit misfit = misfit_of(now_known.deck, done.runs, now_known.records);
      const Estimate now = estimate(misfit, deck.confidence);
      narrow = now.half_width && *now.half_width <= deck.adaptive.half_width ? narrow + 1 : 0;
      work.log().say(fmt::format("{}: {}", counts_of(deck, points), progress_of(now)));
      history += row_of(deck, done, points.size(), now);
      write_text_file(work.directory() + "/search.csv", history);
      if (narrow >= 2 || batch.points == 0) return;
      more = rounded(next_level_points(misfit, now, batch));
    });
    broadcast(work.world(), more, deck.study.parameters.size());
    if (more.empty()) return done;
    points.insert(points.end(), more.begin(), more.end());
    agree_after_root(work.world(), [&] { work.check(points); });
  }
}

}  // namespace repose
