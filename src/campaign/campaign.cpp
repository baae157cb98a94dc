#include "campaign/campaign.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <thread>

#include <fmt/core.h>

#include "base/error.h"
#include "campaign/campaign_watch.h"
#include "campaign/expected_cost.h"
#include "campaign/planned_work.h"
#include "campaign/rank_groups.h"
#include "comm/abort_job.h"
#include "comm/agreement.h"
#include "files/directory.h"
#include "files/shared_file.h"
#include "output/summary.h"

namespace repose {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using LogFile = std::unique_ptr<std::FILE, CloseFile>;

/// The ranks of one group, drawing runs until there are none.
class Group {
 public:
  Group(const Communicator& comm, const CampaignPlan& plan, SharedCounters& counters, CampaignWatch* watch,
        const StopAsked& stop_asked)
      : comm_(comm), plan_(plan), counters_(counters), watch_(watch), stop_asked_(stop_asked) {}

  /// Collective in the group. `next`: the counter of the part. False when it was stopped before all its runs were
  /// drawn.
  bool work(std::span<const StudyRun> runs, std::span<const std::size_t> part, int next) {
    while (true) {
      const std::int64_t drawn = draw(next);
      if (drawn >= std::ssize(part)) return true;
      const StudyRun& run = runs[part[static_cast<std::size_t>(drawn)]];
      if (!do_run(run)) return false;
      if (comm_.is_root()) counters_.add(finished_runs, 1);
      if (!is_as_meant(run)) return false;
    }
  }
  /// Why a complete run is not what was meant. The same in the group.
  const std::optional<Error>& complaint() const { return complaint_; }

 private:
  std::int64_t draw(int next) {
    std::int64_t drawn = comm_.is_root() ? counters_.add(next, 1) : 0;
    comm_.broadcast(drawn);
    return drawn;
  }

  /// False when it was stopped.
  bool do_run(const StudyRun& run) {
    const std::string folder = folder_of(plan_.directory, run);
    LogFile log;
    try {
      agree_after_root(comm_, [&] {
        create_output_directory(folder);
        remove_failure(folder);
        log.reset(std::fopen((folder + "/run.log").c_str(), "a"));
        if (!log) throw FileError(fmt::format("{}/run.log: cannot be opened", folder));
      });
      const RunRequest request = {plan_.bases[plan_.base_of(run)], run.overrides, folder, plan_.level,
                                  {log.get(), log.get()},          true};
      run_file(comm_, request, [&](double needed) { return stop_now(needed); });
    } catch (const Stopped&) {
      if (comm_.is_root()) counters_.add(stop_wanted, 1);
      return false;
    } catch (const Error& error) {  // the same on all ranks of the group
      note_failure(folder, error.code(), error.what());
    } catch (const std::exception& error) {
      if (comm_.size() > 1) throw;                         // on this rank alone, perhaps
      note_failure(folder, ExitCode::file, error.what());  // memory was short, perhaps: it is tried again
    }
    return true;
  }

  /// False when the check of the plan says no: the other groups stop as well.
  bool is_as_meant(const StudyRun& run) {
    if (!plan_.check_run) return true;
    try {
      agree_after_root(comm_, [&] { plan_.check_run(folder_of(plan_.directory, run), run); });
      return true;
    } catch (const Error& error) {  // the same on all ranks of the group
      complaint_ = error;
    }
    if (comm_.is_root()) counters_.add(stop_wanted, 1);
    return false;
  }

  /// Where not even that can be written, the run waits again; the other groups must not wait for this one.
  void note_failure(const std::string& folder, ExitCode code, const std::string& reason) const {
    try {
      if (comm_.is_root()) write_failure(folder, code, reason);
    } catch (const FileError& error) {
      plan_.log.warn(fmt::format("{}; {}", reason, error.what()));
    }
  }

  /// The job's own reason, or that another group has one.
  std::optional<std::string> stop_now(double needed) {
    constexpr double patience = 2.0;  // s
    if (auto reason = stop_asked_ ? stop_asked_(needed) : std::nullopt) return reason;
    if (watch_ != nullptr) watch_->look();
    if (!comm_.is_root() || seconds_since(last_asked_) < patience) return {};
    last_asked_ = WallClock::now();
    if (counters_.recent(stop_wanted) > 0) return "the end of another run of the job";
    return {};
  }

  const Communicator& comm_;
  const CampaignPlan& plan_;
  SharedCounters& counters_;
  CampaignWatch* watch_;  ///< on rank 0 of the world
  const StopAsked& stop_asked_;
  WallClock::time_point last_asked_ = WallClock::now();
  std::optional<Error> complaint_;
};

/// Particles times steps. What cannot be set up will say so when it is run.
double planned_particle_steps(PlannedWork& work, const StudyRun& run) {
  if (work.is_the_same_for_all()) return 1.0;
  try {
    return work(run).particle_steps();
  } catch (const Error&) {
    return 0.0;
  }
}

/// Collective. The runs to do, the same on all ranks, in parts that want the same number of ranks.
std::vector<std::vector<std::size_t>> shared_parts(const Communicator& world, const CampaignPlan& plan,
                                                   std::span<const StudyRun> runs, PlannedWork& work) {
  std::vector<std::size_t> order;
  agree_after_root(world, [&] {
    order = begun_then_longest(runs, read_run_folders(plan.directory, runs, plan.figures), plan.study.parameters,
                               [&](const StudyRun& run) { return planned_particle_steps(work, run); });
  });
  world.broadcast(order);
  return by_ranks(order, runs);
}

/// What this rank has done of the parts.
struct PartsWork {
  double busy_seconds = 0.0;
  bool complete = true;
  std::optional<Error> complaint;

  void add(Group& group, std::span<const StudyRun> runs, std::span<const std::size_t> part, int next) {
    const WallClock::time_point start = WallClock::now();
    complete = group.work(runs, part, next);
    complaint = group.complaint();
    busy_seconds += seconds_since(start);
  }
};

/// Collective. Waits for the others without using a core; rank 0 goes on looking after the whole.
void wait_for_all(const Communicator& world, CampaignWatch* watch) {
  PatientBarrier barrier(world);
  while (!barrier.passed()) {
    if (watch != nullptr) watch->look();
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

/// Collective. Works on the parts, one after the other.
PartsWork work_on(const Communicator& world, const CampaignPlan& plan, std::span<const StudyRun> runs,
                  std::span<const std::vector<std::size_t>> parts, SharedCounters& counters, CampaignWatch* watch,
                  const StopAsked& stop_asked, CampaignEffort& effort) {
  PartsWork work;
  for (std::size_t p = 0; work.complete && p < parts.size(); ++p) {
    const int groups = group_count(world.size(), runs[parts[p].front()].ranks, std::ssize(parts[p]));
    const Communicator comm(world, group_of(world.rank(), world.size(), groups));
    Group group(comm, plan, counters, watch, stop_asked);
    work.add(group, runs, parts[p], next_of_part + static_cast<int>(p));
    wait_for_all(world, watch);
    work.complete = world.min(work.complete ? 1 : 0) == 1;
    effort.groups = std::max(effort.groups, groups);
  }
  return work;
}

}  // namespace

CampaignPlan plan_of(const StudyDeck& study, std::vector<RunFigure> figures, const std::string& deck_text,
                     const RunRequest& request) {
  CampaignPlan plan;
  plan.study = study;
  plan.deck = request.deck;
  plan.deck_text = deck_text;
  plan.command_line = request.overrides;
  plan.figures = std::move(figures);
  plan.directory = request.output;
  plan.level = request.level;
  plan.log = request.log;
  plan.bases = {path_beside(request.deck, study.base)};
  plan.study.set.insert(plan.study.set.end(), request.overrides.begin(), request.overrides.end());
  return plan;
}

std::string copy_of_study(std::string_view text, const RunRequest& request) {
  constexpr std::string_view set = "# --set ";
  while (text.starts_with(set)) {  // of an earlier copy
    text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  }
  std::string copy;
  for (const std::string& override : request.overrides) copy += fmt::format("{}{}\n", set, one_line(override));
  return copy.append(text);
}

std::string effort_text(const CampaignEffort& effort, int ranks) {
  return fmt::format("{} runs in {:.1f} s on {} rank{}, {} at a time; the ranks were idle for {:.1f} % of it\n",
                     effort.runs, effort.wall_seconds, ranks, ranks == 1 ? "" : "s", effort.groups,
                     100.0 * effort.idle_share);
}

void write_campaign_table(const CampaignPlan& plan, const std::vector<std::string>& columns,
                          std::span<const StudyRun> runs, std::span<const RunRecord> records) {
  GridTable table{plan.deck_text,   {},   columns, plan.levels,
                  plan.experiments, runs, records, build_info(to_string(plan.level))};
  for (const ParameterDeck& p : plan.study.parameters) table.parameters.push_back(p.name);
  write_grid_table(plan.directory, table);
}

std::vector<RunRecord> run_campaign(const Communicator& world, const CampaignPlan& plan, std::span<const StudyRun> runs,
                                    const StopAsked& stop_asked, CampaignEffort& effort) {
  PlannedWork planned(plan);
  const std::vector<std::vector<std::size_t>> parts = shared_parts(world, plan, runs, planned);
  SharedCounters counters(world, next_of_part + static_cast<int>(parts.size()));
  std::optional<CampaignWatch> watch;
  if (world.is_root()) {
    watch.emplace(plan, runs, parts, counters,
                  [&](const StudyRun& run) { return planned_particle_steps(planned, run); });
  }
  CampaignWatch* const my_watch = watch ? &*watch : nullptr;

  const WallClock::time_point start = WallClock::now();
  PartsWork work;
  try {
    work = work_on(world, plan, runs, parts, counters, my_watch, stop_asked, effort);
  } catch (const Error&) {  // on all ranks
    throw;
  } catch (const std::exception& error) {  // on this rank alone, perhaps: to end the counters takes all of them
    abort_job(world, error.what());
  }
  effort.wall_seconds = world.max(seconds_since(start));
  effort.idle_share = parts.empty() ? 0.0 : 1.0 - world.sum(work.busy_seconds) / (effort.wall_seconds * world.size());
  effort.runs = world.sum(world.is_root() ? counters.read(finished_runs) : 0);
  std::vector<RunRecord> records;
  agree_after_root(world, [&] { records = watch->finish(); });
  if (work.complete) return records;
  agree_after(world, [&] {
    if (work.complaint) throw *work.complaint;
  });
  std::int64_t complete =
      std::count_if(records.begin(), records.end(), [](const auto& r) { return is_complete(r.state); });
  world.broadcast(complete);
  throw Stopped(
      fmt::format("stopped with {} of {} runs complete; the same command goes on from there", complete, runs.size()));
}

}  // namespace repose
