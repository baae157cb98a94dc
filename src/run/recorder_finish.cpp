#include <ctime>

#include <fmt/core.h>

#include "base/error.h"
#include "comm/agreement.h"
#include "measurement/state_hash.h"
#include "run/cost.h"
#include "run/recorder.h"

namespace repose {

/// What the watches have seen, and what can be told from the grains at the end. What cannot be measured, such as with a
/// camera inside the pile, must not cost the rest of a run's results.
Figures Recorder::measured(const Simulation& simulation, const ReadFile& read_file, std::int64_t left) const {
  const Deck& deck = simulation.deck();
  Figures figures = no_figures();
  for (const Watched& w : watches_) {
    try {
      w.watch->finish(simulation, read_file, figures);
    } catch (const Stopped&) {
      throw;
    } catch (const Error& error) {  // of a further run, on all ranks alike
      if (simulation.comm().is_root()) options_.log.warn(fmt::format("no {}: {}", name_of(*w.kind), error.what()));
    }
  }
  std::vector<const MeasurementKind*> of_grains;
  for (const MeasurementKind& kind : measurement_kinds()) {
    if (kind.watch == nullptr && kind.is_enabled(deck)) of_grains.push_back(&kind);
  }
  if (of_grains.empty()) return figures;
  GatheredGrains grains = gather_grains(simulation);
  const FinishedState state{.deck = deck,
                            .grains = std::move(grains.spheres),
                            .mass = std::move(grains.mass),
                            .left = left,
                            .directory = options_.directory};
  agree_after_root(simulation.comm(), [&] {
    for (const MeasurementKind* kind : of_grains) {
      try {
        kind->measure(state, figures);
        if (kind->lines != nullptr && kind->lines(figures).empty()) options_.log.say(absence_of(*kind));
      } catch (const DeckError& error) {
        options_.log.warn(fmt::format("no {}: {}", name_of(*kind), error.what()));
      }
    }
  });
  return figures;
}

/// Particles that the deck plans and that are not there at the end.
void Recorder::report_absent(const Summary& s) const {
  if (s.inserted < s.planned) {
    options_.log.warn(
        fmt::format("{} of the {} planned particles were not poured before the run ended; let its phases "
                    "last longer, or pour faster (particle_rate, interval, start_time)",
                    s.planned - s.inserted, s.planned));
  }
  if (s.left == 0) return;
  std::string by_exit;
  for (const ExitSummary& exit : s.exits) {
    if (exit.particles > 0) by_exit += fmt::format("{}{} {}", by_exit.empty() ? "" : ", ", exit.name, exit.particles);
  }
  options_.log.say(fmt::format("{} of {} particles have left the domain: {}", s.left, s.inserted, by_exit));
}

Summary Recorder::finish(const Simulation& simulation, const ReadFile& read_file, const CheckpointCost& checkpoints) {
  const Communicator& comm = simulation.comm();
  Summary s;
  s.loop_wall_seconds = seconds_since(start_);
  const double cpu_seconds = static_cast<double>(std::clock() - cpu_start_) / CLOCKS_PER_SEC;
  s.loop_cpu_seconds = comm.sum(cpu_seconds);
  s.particle_steps_per_cpu_second = particle_steps_ / s.loop_cpu_seconds;
  s.cost = loop_cost(simulation, cpu_seconds);
  s.checkpoints = checkpoints;
  write_snapshot_now(simulation);
  if (!phases_.empty()) write_series_row(simulation, phases_.back().name);

  s.status = "done";
  s.title = simulation.deck().run.title;
  s.ranks = comm.size();
  s.steps = simulation.steps();
  s.time_s = simulation.time();
  s.timestep_s = simulation.time_step().step;
  s.timestep_set_by = simulation.time_step().criterion;
  s.inserted = simulation.inserted();
  s.planned = simulation.planned();
  s.inside = inside(simulation);
  s.sizes = simulation.sizes();
  for (const ExitTotal& exit : exit_totals(simulation.deck().exits, sum_of(comm, simulation.left_here()))) {
    s.exits.push_back({exit.name, exit.particles, simulation.mass_unit().kilograms(exit.mass)});
    s.left += exit.particles;
  }
  if (comm.is_root()) report_absent(s);
  s.state_hash = state_hash(comm, simulation.particles(), simulation.pairs(), simulation.wall_contacts());
  s.phases = phases_;
  s.figures = measured(simulation, read_file, s.left);
  const Effort all = effort();
  s.restarts = all.restarts;
  s.wall_seconds = all.wall_seconds;
  s.particle_steps_per_second = all.particle_steps / all.wall_seconds;
  s.build = options_.build;
  s.deck = options_.resolved_deck;
  agree_after_root(comm, [&] { write_summary(path("summary.json"), s); });
  return s;
}

}  // namespace repose
