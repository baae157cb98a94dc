#include "campaign/planned_work.h"

#include <algorithm>
#include <limits>
#include <set>

#include <fmt/core.h>

#include "deck/read_deck.h"
#include "files/shared_file.h"
#include "output/progress.h"
#include "run/run_plan.h"

namespace repose {
namespace {

PlannedRun planned_run(const CampaignPlan& plan, const StudyRun& run) {
  const std::string& base = plan.bases[plan.base_of(run)];
  const Deck deck = read_deck(read_whole_file(base), base, run.overrides);
  const RunPlan made(deck, [&](const std::string& file) { return read_whole_file(path_beside(base, file)); });
  return {static_cast<double>(made.insertion.planned), most_steps(deck, made.dt)};
}

/// "46811", "9363 to 15952".
class Span {
 public:
  void add(double value) {
    least_ = std::min(least_, value);
    most_ = std::max(most_, value);
  }
  std::string text() const {
    return least_ == most_ ? fmt::format("{:.0f}", least_) : fmt::format("{:.0f} to {:.0f}", least_, most_);
  }

 private:
  double least_ = std::numeric_limits<double>::infinity();
  double most_ = 0.0;
};

/// The runs of one base deck.
struct RunsOfBase {
  std::string name;
  std::int64_t runs = 0;
  std::int64_t ranks = 1;  ///< for each of them, at least
  std::set<std::vector<double>> points;
  Span particles;
  Span steps;

  std::string text() const {
    std::string line = "runs        ";
    if (!name.empty()) line += name + ": ";
    if (runs > 1) line += fmt::format("{} at {} points, each ", runs, points.size());
    line += fmt::format("{} particles, at most {} steps", particles.text(), steps.text());
    if (ranks > 1) line += fmt::format(", {} ranks or more", ranks);
    return line + "\n";
  }
};

std::string name_of_base(const CampaignPlan& plan, const StudyRun& run) {
  std::string name;
  if (!plan.experiments.empty()) name = plan.experiments[run.experiment];
  if (!plan.levels.empty()) name += (name.empty() ? "" : "/") + plan.levels[run.level];
  return name;
}

}  // namespace

PlannedWork::PlannedWork(const CampaignPlan& plan) : plan_(plan) {
  const std::vector<ParameterDeck>& parameters = plan.study.parameters;
  const auto is_of_pair = [](const ParameterDeck& p) { return p.key.starts_with("pair."); };
  alike_ = std::all_of(parameters.begin(), parameters.end(), is_of_pair);
}

const PlannedRun& PlannedWork::operator()(const StudyRun& run) {
  const std::pair key(plan_.base_of(run), alike_ ? std::vector<double>() : run.values);
  const auto found = known_.find(key);
  return found != known_.end() ? found->second : known_.emplace(key, planned_run(plan_, run)).first->second;
}

std::string planned_work_text(const CampaignPlan& plan, std::span<const StudyRun> runs, double core_speed, int ranks) {
  check_campaign(plan, runs);
  PlannedWork work(plan);
  std::vector<RunsOfBase> of_base(plan.bases.size());
  double particle_steps = 0.0;
  for (const StudyRun& run : runs) {
    const PlannedRun& planned = work(run);
    RunsOfBase& base = of_base[plan.base_of(run)];
    base.name = name_of_base(plan, run);
    base.runs += 1;
    base.ranks = run.ranks;
    base.points.insert(run.values);
    base.particles.add(planned.particles);
    base.steps.add(planned.steps);
    particle_steps += planned.particle_steps();
  }
  std::string text;
  for (const RunsOfBase& base : of_base) text += base.text();
  const double core_hours = particle_steps / core_speed / 3600.0;
  text += fmt::format("core-hours  about {:.{}f} at {:g} particle-steps/s and core, if every phase takes its longest\n",
                      core_hours, core_hours < 10.0 ? 2 : 0, core_speed);
  text += fmt::format("wall time   about {} on {} rank{}\n", duration_text(3600.0 * core_hours / ranks), ranks,
                      ranks == 1 ? "" : "s");
  return text;
}

}  // namespace repose
