#pragma once

#include <span>
#include <vector>

#include "base/wall_clock.h"
#include "campaign/campaign.h"
#include "comm/shared_counters.h"

namespace repose {

/// The counters that the groups of a campaign share.
enum CampaignCounter { next_run, finished_runs, failed_runs, stop_wanted, campaign_counters };

/// Rank 0 looks after the whole while it works on a run of its own: progress lines and the tables.
class CampaignWatch {
 public:
  /// `order`: the runs that are drawn, one after the other. Refers to its arguments.
  CampaignWatch(const CampaignPlan& plan, std::span<const StudyRun> runs, std::span<const std::size_t> order,
                SharedCounters& counters);

  /// A progress line and new tables when runs have ended since the last, at most every few seconds; the report, if
  /// there is to be one.
  void look();
  /// The records of all runs, from their folders, and the tables.
  std::vector<RunRecord> write_tables();

 private:
  void look_at_runs();
  std::string progress(std::int64_t finished, std::int64_t failed, std::int64_t drawn) const;

  const CampaignPlan& plan_;
  std::span<const StudyRun> runs_;
  std::span<const std::size_t> order_;
  SharedCounters& counters_;
  WallClock::time_point start_ = WallClock::now();
  WallClock::time_point last_look_ = start_;
  std::int64_t last_finished_ = -1;
};

}  // namespace repose
