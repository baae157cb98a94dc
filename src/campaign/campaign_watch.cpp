#include "campaign/campaign_watch.h"

#include <algorithm>

#include <fmt/core.h>

#include "campaign/rank_groups.h"
#include "output/progress.h"

namespace repose {

CampaignWatch::CampaignWatch(const CampaignPlan& plan, std::span<const StudyRun> runs,
                             std::span<const std::vector<std::size_t>> parts, SharedCounters& counters)
    : plan_(plan), runs_(runs), parts_(parts), to_do_(run_count(parts)), counters_(counters) {}

void CampaignWatch::look() {
  constexpr double patience = 2.0;  // s
  counters_.answer();
  if (seconds_since(last_look_) < patience) return;
  last_look_ = WallClock::now();
  look_at_runs();
  if (plan_.report != nullptr) plan_.report->renew();
}

void CampaignWatch::look_at_runs() {
  const std::int64_t finished = counters_.read(finished_runs);
  if (finished == last_finished_) return;
  last_finished_ = finished;
  plan_.log.say(progress(finished, counters_.read(failed_runs), std::ssize(drawn_runs())));
  try {
    write_tables();
  } catch (const FileError& error) {  // in the midst of a run: the tables of the end are made without it
    plan_.log.warn(error.what());
  }
}

std::vector<std::size_t> CampaignWatch::drawn_runs() const {
  std::vector<std::size_t> drawn;
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    const std::vector<std::size_t>& part = parts_[p];
    const std::int64_t begun = counters_.read(next_of_part + static_cast<int>(p));
    drawn.insert(drawn.end(), part.begin(), part.begin() + std::min(begun, std::ssize(part)));
  }
  return drawn;
}

std::string CampaignWatch::progress(std::int64_t finished, std::int64_t failed, std::int64_t drawn) const {
  const std::int64_t before = std::ssize(runs_) - to_do_;
  std::string text = fmt::format("runs {} of {} done, {} running, {} failed", before + finished - failed, runs_.size(),
                                 drawn - finished, failed);
  if (finished > 0) {
    const double each = seconds_since(start_) / static_cast<double>(finished);
    text += fmt::format(", {} left", duration_text(each * static_cast<double>(to_do_ - finished)));
  }
  return text;
}

std::vector<RunRecord> CampaignWatch::write_tables() {
  std::vector<RunRecord> records = read_run_folders(plan_.directory, runs_, plan_.figures);
  for (const std::size_t run : drawn_runs()) {
    if (records[run].state == RunState::waiting) records[run].state = RunState::running;
  }
  std::vector<std::string> columns;
  for (const RunFigure& figure : plan_.figures) columns.push_back(figure.column);
  write_campaign_table(plan_, columns, runs_, records);
  return records;
}

}  // namespace repose
