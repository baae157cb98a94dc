#include "campaign/campaign_watch.h"

#include <algorithm>

#include <fmt/core.h>

#include "output/progress.h"

namespace repose {

CampaignWatch::CampaignWatch(const CampaignPlan& plan, std::span<const StudyRun> runs,
                             std::span<const std::size_t> order, SharedCounters& counters)
    : plan_(plan), runs_(runs), order_(order), counters_(counters) {}

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
  const std::int64_t drawn = std::min(counters_.read(next_run), std::ssize(order_));
  plan_.log.say(progress(finished, counters_.read(failed_runs), drawn));
  try {
    write_tables();
  } catch (const FileError& error) {  // in the midst of a run: the tables of the end are made without it
    plan_.log.warn(error.what());
  }
}

std::string CampaignWatch::progress(std::int64_t finished, std::int64_t failed, std::int64_t drawn) const {
  const std::int64_t before = std::ssize(runs_) - std::ssize(order_);
  std::string text = fmt::format("runs {} of {} done, {} running, {} failed", before + finished - failed, runs_.size(),
                                 drawn - finished, failed);
  if (finished > 0) {
    const double each = seconds_since(start_) / static_cast<double>(finished);
    text += fmt::format(", {} left", duration_text(each * static_cast<double>(std::ssize(order_) - finished)));
  }
  return text;
}

std::vector<RunRecord> CampaignWatch::write_tables() {
  const std::int64_t drawn = std::min(counters_.read(next_run), std::ssize(order_));
  std::vector<RunRecord> records = read_run_folders(plan_.directory, runs_, plan_.figures);
  for (std::int64_t k = 0; k < drawn; ++k) {
    RunRecord& record = records[order_[static_cast<std::size_t>(k)]];
    if (record.state == RunState::waiting) record.state = RunState::running;
  }
  std::vector<std::string> columns;
  for (const RunFigure& figure : plan_.figures) columns.push_back(figure.column);
  write_campaign_table(plan_, columns, runs_, records);
  return records;
}

}  // namespace repose
