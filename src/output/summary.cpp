#include "output/summary.h"

#include <nlohmann/json.hpp>

#include "files/atomic_file.h"
#include "files/json_text.h"

namespace repose {

namespace {

using Json = nlohmann::ordered_json;  // the order of the file is the order of reading

Json particles_json(const Summary& summary) {
  Json exits = Json::object();
  Json masses = Json::object();
  for (const ExitSummary& exit : summary.exits) {
    exits[exit.name] = exit.particles;
    masses[exit.name] = json_number(exit.mass_kg);
  }
  return {{"planned", summary.planned},
          {"inserted", summary.inserted},
          {"inside", summary.inside},
          {"left", summary.left},
          {"exits", exits},
          {"exit_mass_kg", masses}};
}

Json figures_json(const SizeFigures& figures) {
  return {{"d10_m", figures.d10},
          {"d50_m", figures.d50},
          {"d90_m", figures.d90},
          {"mean_m", figures.mean},
          {"mass_shares", figures.mass_shares}};
}

Json sizes_json(const std::vector<SizeReport>& sizes) {
  Json list = Json::array();
  for (const SizeReport& report : sizes) {
    Json classes = Json::array();
    for (const SizeClass& c : report.classes) classes.push_back({c.from, c.to});
    list.push_back({{"block", report.block},
                    {"classes_m", classes},
                    {"asked", figures_json(report.asked)},
                    {"realised", figures_json(report.realised)}});
  }
  return list;
}

Json phases_json(const std::vector<PhaseSummary>& phases) {
  Json list = Json::array();
  for (const PhaseSummary& phase : phases) {
    list.push_back({{"name", phase.name}, {"steps", phase.steps}, {"ended_by", phase.ended_by}});
  }
  return list;
}

Json timing_json(const Summary& summary) {
  Json stages = Json::object();
  for (const StageSummary& stage : summary.cost.stages) {
    stages[stage.name] = {{"mean_s", json_number(stage.mean_seconds)}, {"max_s", json_number(stage.max_seconds)}};
  }
  return {{"loop_wall_s", json_number(summary.loop_wall_seconds)},
          {"loop_cpu_s", json_number(summary.loop_cpu_seconds)},
          {"particle_steps_per_cpu_second", json_number(summary.particle_steps_per_cpu_second)},
          {"checkpoints", summary.checkpoints.written},
          {"checkpoints_wall_s", json_number(summary.checkpoints.seconds)},
          {"stages", stages}};
}

Json lists_json(const Summary& summary) {
  return {{"rebuilds", summary.cost.list_rebuilds},
          {"inner_selections", summary.cost.inner_selections},
          {"listed_pairs_per_particle", json_number(summary.cost.listed_pairs_per_particle)},
          {"evaluated_pairs_per_particle", json_number(summary.cost.evaluated_pairs_per_particle)},
          {"ghosts", summary.cost.ghosts},
          {"most_ghosts_of_a_rank", summary.cost.most_ghosts_of_a_rank}};
}

Json spread_json(const RankSpread& spread) {
  return {
      {"min", json_number(spread.least)}, {"mean", json_number(spread.mean)}, {"max", json_number(spread.greatest)}};
}

Json parallel_json(const ParallelSummary& p) {
  return {{"bisections", p.bisections},
          {"imbalance", json_number(p.imbalance)},
          {"loop_cpu_s", spread_json(p.loop_cpu_seconds)},
          {"work_cpu_s", spread_json(p.work_cpu_seconds)},
          {"pairs_per_step", spread_json(p.pairs_per_step)},
          {"ghosts_per_step", spread_json(p.ghosts_per_step)},
          {"messages_per_step", spread_json(p.messages_per_step)},
          {"bytes_per_step", spread_json(p.bytes_per_step)},
          {"collectives_per_step", json_number(p.collectives_per_step)}};
}

Json memory_json(const Summary& summary) {
  return {{"peak_bytes", summary.cost.memory_peak_bytes},
          {"bytes_per_particle", json_number(summary.cost.memory_bytes_per_particle)}};
}

}  // namespace

std::string summary_json(const Summary& summary) {
  Json json = {
      {"status", summary.status},
      {"title", summary.title},
      {"ranks", summary.ranks},
      {"steps", summary.steps},
      {"time_s", json_number(summary.time_s)},
      {"timestep_s", json_number(summary.timestep_s)},
      {"timestep_set_by", summary.timestep_set_by},
      {"particles", particles_json(summary)},
      {"sizes", sizes_json(summary.sizes)},
      {"state_hash", summary.state_hash},
      {"phases", phases_json(summary.phases)},
  };
  json.update(summary.figures);
  json.update(Json{
      {"restarts", summary.restarts},
      {"wall_seconds", json_number(summary.wall_seconds)},
      {"particle_steps_per_second", json_number(summary.particle_steps_per_second)},
      {"timing", timing_json(summary)},
      {"lists", lists_json(summary)},
      {"parallel", parallel_json(summary.cost.parallel)},
      {"memory", memory_json(summary)},
      {"build", json_of(summary.build)},
      {"deck", summary.deck},
  });
  return json_text(json);
}

void write_summary(const std::string& path, const Summary& summary) { write_text_file(path, summary_json(summary)); }

}  // namespace repose
