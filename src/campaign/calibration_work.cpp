#include "campaign/calibration_work.h"

#include <algorithm>
#include <utility>

#include "campaign/level_runs.h"
#include "campaign/planned_work.h"
#include "comm/agreement.h"
#include "files/shared_file.h"

namespace repose {
namespace {

CampaignPlan plan_of_levels(const CalibrationDeck& deck, const std::string& text, const RunRequest& request) {
  CampaignPlan plan = plan_of(deck.study, run_figures(deck), text, request);
  plan.bases.clear();
  for (std::size_t experiment = 0; experiment < deck.experiment_count(); ++experiment) {
    for (std::size_t level = 0; level < deck.level_count(); ++level) {
      plan.bases.push_back(path_beside(request.deck, study_of_level(deck, level, experiment).base));
    }
  }
  for (const LevelDeck& level : deck.levels) plan.levels.push_back(level.name);
  for (const ExperimentDeck& experiment : deck.experiments) plan.experiments.push_back(experiment.name);
  return plan;
}

}  // namespace

CalibrationWork::CalibrationWork(const Communicator& world, const CalibrationDeck& deck, const std::string& text,
                                 const RunRequest& request, const StopAsked& stop_asked)
    : world_(world),
      deck_(deck),
      overrides_(request.overrides),
      stop_asked_(stop_asked),
      plan_(plan_of_levels(deck, text, request)) {
  plan_.check_deck = [&deck](const Deck& run, std::size_t experiment) { check_curves(deck, run, experiment); };
  plan_.check_run = [&deck](const std::string& folder, const StudyRun& run) { check_curves(deck, folder, run); };
}

std::vector<RunFigure> run_figures(const CalibrationDeck& deck) {
  std::vector<RunFigure> figures;
  for (const ObservableDeck& o : deck.observables) {
    if (!o.is_curve()) figures.push_back({o.figure, o.key, o.experiment});
  }
  return figures;
}

void CalibrationWork::write_table(const Projection& projection, std::span<const StudyRun> runs) const {
  if (projection.curves.empty()) return;
  std::vector<std::string> columns;
  for (const ObservableDeck& o : projection.deck.observables) columns.push_back(o.figure);
  write_campaign_table(plan_, columns, runs, projection.records);
}

std::string CalibrationWork::planned(std::span<const LevelPoint> points) const {
  const std::vector<StudyRun> runs = level_runs(deck_, overrides_, points);
  return planned_work_text(plan_, runs, deck_.adaptive.core_speed, world_.size());
}

void CalibrationWork::check(std::span<const LevelPoint> points) const {
  check_campaign(plan_, level_runs(deck_, overrides_, points));
}

DoneRuns CalibrationWork::at(std::span<const LevelPoint> points) {
  std::vector<StudyRun> runs = level_runs(deck_, overrides_, points);
  CampaignEffort now;
  std::vector<RunRecord> records = run_campaign(world_, plan_, runs, stop_asked_, now);
  const double before = effort_.wall_seconds * effort_.idle_share;
  effort_.wall_seconds += now.wall_seconds;
  if (effort_.wall_seconds > 0.0) {
    effort_.idle_share = (before + now.wall_seconds * now.idle_share) / effort_.wall_seconds;
  }
  effort_.runs += now.runs;
  effort_.groups = std::max(effort_.groups, now.groups);
  return {std::move(runs), std::move(records)};
}

}  // namespace repose
