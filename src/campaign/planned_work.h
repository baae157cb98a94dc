#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "campaign/campaign.h"

namespace repose {

/// What a run would be, before anything is known of it.
struct PlannedRun {
  double particles = 0.0;
  double steps = 0.0;  ///< when every phase takes its longest

  double particle_steps() const { return particles * steps; }
};

/// The same for many runs of a plan, which it refers to: one scene is set up for all of a base deck at one point, or
/// for all of a base deck that differ in the laws of the contacts alone.
class PlannedWork {
 public:
  explicit PlannedWork(const CampaignPlan& plan);

  /// DeckError and FileError as the run would.
  const PlannedRun& operator()(const StudyRun& run);
  /// Whether all runs are alike, as far as this can tell.
  bool is_the_same_for_all() const { return alike_ && plan_.bases.size() == 1; }

 private:
  const CampaignPlan& plan_;
  bool alike_ = false;
  std::map<std::pair<std::size_t, std::vector<double>>, PlannedRun> known_;  ///< by base deck and point
};

/// Lines for a person: what each level of each test asks for, core-hours at `core_speed` particle-steps a second and
/// core, wall time on so many ranks. DeckError and FileError as check_campaign and the runs, before the first of them.
std::string planned_work_text(const CampaignPlan& plan, std::span<const StudyRun> runs, double core_speed, int ranks);

}  // namespace repose
