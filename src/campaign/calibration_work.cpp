#include "campaign/calibration_work.h"

#include <algorithm>
#include <utility>

#include "campaign/level_runs.h"
#include "comm/agreement.h"
#include "files/shared_file.h"

namespace repose {
namespace {

CampaignPlan plan_of_levels(const CalibrationDeck& deck, const std::string& text, const RunRequest& request) {
  std::vector<std::string> figures;
  for (const ObservableDeck& o : deck.observables) figures.push_back(o.figure);
  CampaignPlan plan = plan_of(deck.study, std::move(figures), text, request);
  if (deck.levels.empty()) return plan;
  plan.bases.clear();
  for (std::size_t level = 0; level < deck.levels.size(); ++level) {
    plan.bases.push_back(path_beside(request.deck, study_of_level(deck, level).base));
    plan.levels.push_back(deck.levels[level].name);
  }
  return plan;
}

}  // namespace

CalibrationWork::CalibrationWork(const Communicator& world, const CalibrationDeck& deck, const std::string& text,
                                 const RunRequest& request, const StopAsked& stop_asked, LiveReport* report)
    : world_(world),
      deck_(deck),
      overrides_(request.overrides),
      stop_asked_(stop_asked),
      plan_(plan_of_levels(deck, text, request)) {
  plan_.report = report;
}

DoneRuns CalibrationWork::at(std::span<const LevelPoint> points) {
  std::vector<StudyRun> runs = level_runs(deck_, overrides_, points);
  agree_after_root(world_, [&] { check_campaign(plan_, runs); });
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
