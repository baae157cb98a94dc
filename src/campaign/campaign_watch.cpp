#include "campaign/campaign_watch.h"

#include <algorithm>

#include <fmt/core.h>

#include "output/progress.h"

namespace repose {

CampaignWatch::CampaignWatch(const CampaignPlan& plan, std::span<const StudyRun> runs,
                             std::span<const std::vector<std::size_t>> parts, SharedCounters& counters,
                             const WorkOf& work_of)
    : plan_(plan), runs_(runs), parts_(parts), counters_(counters), work_(runs.size()) {
  for (const std::vector<std::size_t>& part : parts) {
    for (const std::size_t run : part) work_[run] = work_of(runs[run]);
  }
}

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
  try {
    std::vector<RunRecord> records = read_records();
    for (const std::size_t run : drawn_runs()) {
      if (records[run].state == RunState::waiting && records[run].reason.empty())
        records[run].state = RunState::running;
    }
    plan_.log.say(progress(records));
    write_tables(records);
  } catch (const std::exception& error) {  // in the midst of a run, which has no part in it: the end will show
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

std::string CampaignWatch::progress(std::span<const RunRecord> records) const {
  const auto count = [&](auto&& is) { return std::count_if(records.begin(), records.end(), is); };
  return fmt::format("runs {} of {} done, {} running, {} failed{}",
                     count([](const RunRecord& r) { return is_complete(r.state); }), records.size(),
                     count([](const RunRecord& r) { return r.state == RunState::running; }),
                     count([](const RunRecord& r) { return !r.reason.empty(); }), left_text(records));
}

std::string CampaignWatch::left_text(std::span<const RunRecord> records) const {
  double done = 0.0;
  double left = 0.0;
  for (const std::vector<std::size_t>& part : parts_) {
    for (const std::size_t run : part) left += work_[run];
  }
  for (const std::size_t run : drawn_runs()) {
    if (!is_complete(records[run].state) && records[run].reason.empty()) continue;
    left -= work_[run];
    done += work_[run];
  }
  return done > 0.0 ? fmt::format(", {} left", duration_text(seconds_since(start_) * left / done)) : "";
}

std::vector<RunRecord> CampaignWatch::read_records() const {
  return read_run_folders(plan_.directory, runs_, plan_.figures);
}

void CampaignWatch::write_tables(std::span<const RunRecord> records) const {
  std::vector<std::string> columns;
  for (const RunFigure& figure : plan_.figures) columns.push_back(figure.column);
  write_campaign_table(plan_, columns, runs_, records);
}

std::vector<RunRecord> CampaignWatch::finish() const {
  std::vector<RunRecord> records = read_records();
  write_tables(records);
  return records;
}

}  // namespace repose
