#pragma once

#include <span>
#include <vector>

#include "base/wall_clock.h"
#include "campaign/campaign.h"
#include "campaign/expected_cost.h"
#include "comm/shared_counters.h"

namespace repose {

/// The counters that the groups of a campaign share; from `next_of_part` on there is one for each part, which counts
/// what is drawn of its runs.
enum CampaignCounter { finished_runs, stop_wanted, next_of_part };

/// Rank 0 looks after the whole while it works on a run of its own: progress lines and the tables.
class CampaignWatch {
 public:
  /// `parts`: the runs that are drawn, part after part; `work_of`, by which the time that is left is told, is asked
  /// once for each. Refers to its other arguments.
  CampaignWatch(const CampaignPlan& plan, std::span<const StudyRun> runs,
                std::span<const std::vector<std::size_t>> parts, SharedCounters& counters, const WorkOf& work_of);

  /// A progress line and new tables when runs have ended since the last, at most every few seconds; the report, if
  /// there is to be one.
  void look();
  /// The records of all runs, from their folders, and the tables: when none is at work any more.
  std::vector<RunRecord> finish() const;

 private:
  void look_at_runs();
  std::vector<RunRecord> read_records() const;
  void write_tables(std::span<const RunRecord> records) const;
  std::vector<std::size_t> drawn_runs() const;
  std::string progress(std::span<const RunRecord> records) const;
  std::string left_text(std::span<const RunRecord> records) const;

  const CampaignPlan& plan_;
  std::span<const StudyRun> runs_;
  std::span<const std::vector<std::size_t>> parts_;
  SharedCounters& counters_;
  std::vector<double> work_;  ///< of each run that is in a part
  WallClock::time_point start_ = WallClock::now();
  WallClock::time_point last_look_ = start_;
  std::int64_t last_finished_ = -1;
};

}  // namespace repose
