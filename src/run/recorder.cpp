#include "run/recorder.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <numeric>
#include <utility>

#include <fmt/core.h>

#include "base/error.h"
#include "base/wall_clock.h"
#include "comm/agreement.h"
#include "files/atomic_file.h"
#include "files/directory.h"
#include "heat/heat_figures.h"
#include "measurement/discharged_mass.h"
#include "measurement/energies.h"
#include "output/collect_particles.h"
#include "output/progress.h"

namespace repose {
namespace {

/// Followed by those of [heat], and one for each named exit.
const std::vector<std::string> series_columns = {"step",
                                                 "time_s",
                                                 "phase",
                                                 "particles",
                                                 "pair_contacts",
                                                 "wall_contacts",
                                                 "translational_energy_J",
                                                 "rotational_energy_J",
                                                 "gravitational_energy_J",
                                                 "elastic_energy_J",
                                                 "discharged_mass_kg"};

const std::vector<std::string> heat_columns = {"heat_J", "mean_temperature_K", "lowest_temperature_K",
                                               "highest_temperature_K"};

std::vector<std::string> columns_of(const Deck& deck) {
  std::vector<std::string> columns = series_columns;
  if (deck.heat.enabled) columns.insert(columns.end(), heat_columns.begin(), heat_columns.end());
  for (const ExitDeck& exit : deck.exits) columns.push_back(fmt::format("exit_{}_kg", exit.name));
  return columns;
}

double discharged_mass_of(const Simulation& simulation) {
  return discharged_mass(simulation.comm(), simulation.deck().discharge.orifice_height, simulation.materials(),
                         simulation.mass_unit(), simulation.particles(), simulation.left_here());
}

std::int64_t every(double interval, double timestep) {
  return interval > 0.0 ? std::max<std::int64_t>(1, steps_for(interval, timestep)) : 0;
}

/// Why a phase that was ended by this had no step.
const char* reason_of_no_step(const std::string& ended_by) {
  if (ended_by == "kinetic_energy") return "what has not begun to move is at rest as well; give it a min_time";
  if (ended_by == "time" || ended_by == "max_time") return "its time is less than half a time step";
  return "what it waits for was there already";
}

}  // namespace

Recorder::Recorder(const Simulation& simulation, const OutputOptions& options, Existing existing)
    : options_(options),
      series_every_(every(simulation.deck().output.series_interval, simulation.time_step().step)),
      snapshot_every_(every(simulation.deck().output.snapshot_interval, simulation.time_step().step)),
      snapshots_(options.directory + "/run.hdf.series"),
      start_(WallClock::now()),
      last_progress_(start_) {
  const Deck& deck = simulation.deck();
  const double dt = simulation.time_step().step;
  total_steps_ = std::accumulate(deck.phases.begin(), deck.phases.end(), std::int64_t{0},
                                 [&](std::int64_t sum, const PhaseDeck& p) { return sum + longest_steps(p, dt); });
  for (const double t : deck.output.snapshot_times) snapshot_steps_.push_back(steps_for(t, dt));
  const auto opening =
      std::find_if(deck.phases.begin(), deck.phases.end(), [](const PhaseDeck& p) { return !p.remove_walls.empty(); });
  opening_phase_ = opening == deck.phases.end() ? deck.phases.front().name : opening->name;
  agree_after_root(simulation.comm(), [&] {
    if (existing == Existing::replace) remove_earlier_results();
    write_text_file(path("deck.resolved.toml"), options_.resolved_deck);
    series_ = std::make_unique<TimeSeries>(path("series.csv"), columns_of(deck), existing);
    if (deck.output.trace) trace_ = std::make_unique<Trace>(path("trace.csv"), existing);
  });
  if (!deck.walls.empty()) wall_loads_.emplace(simulation, path("walls.csv"), existing);
  for (const MeasurementKind& kind : measurement_kinds()) {
    if (kind.watch != nullptr && kind.is_enabled(deck)) {
      watches_.push_back({&kind, kind.watch(simulation, {options_.directory, existing})});
    }
  }
  inside_ = inside(simulation);
  if (deck.output.trace && existing == Existing::replace) write_trace(simulation);
}

std::int64_t Recorder::inside(const Simulation& simulation) const {
  const auto& left = simulation.left_here().particles;
  const Particles& particles = simulation.particles();
  std::array<std::int64_t, 2> count = {0, std::accumulate(left.begin(), left.end(), std::int64_t{0})};
  for (std::size_t i = 0; i < particles.owned; ++i) count[0] += is_parked(particles.record[i]) ? 0 : 1;
  simulation.comm().sum_elements(std::span(count.begin(), count.end()));
  if (count[0] + count[1] != simulation.inserted()) {
    throw PhysicsError(
        fmt::format("step {}: {} particles were inserted, but {} are inside and {} have left: some were lost",
                    simulation.steps(), simulation.inserted(), count[0], count[1]));
  }
  return count[0];
}

void Recorder::phase_begins(const Simulation& simulation, const Phase& phase) {
  if (!opened_ && phase.deck().name == opening_phase_) {
    opened_ = true;
    for (const Watched& w : watches_) w.watch->vessel_opens(simulation);
  }
  if (simulation.steps() == 0) {
    write_series_row(simulation, phase.deck().name);
    if (is_asked_for(0)) write_snapshot_now(simulation);
  }
  for (const Watched& w : watches_) w.watch->phase_begins(simulation, phase.deck().name);
}

bool Recorder::is_asked_for(std::int64_t step) const {
  return std::find(snapshot_steps_.begin(), snapshot_steps_.end(), step) != snapshot_steps_.end();
}

Recorder::Due Recorder::due_at(std::int64_t step, const Deck& deck) const {
  return {
      .trace = deck.output.trace && step % deck.output.trace_every == 0,
      .check = step % deck.run.check_every == 0,
      .series = series_every_ > 0 && step % series_every_ == 0,
      .snapshot = (snapshot_every_ > 0 && step % snapshot_every_ == 0) || is_asked_for(step),
      .sample = std::any_of(watches_.begin(), watches_.end(), [&](const Watched& w) { return w.watch->is_due(step); })};
}

std::int64_t Recorder::steps_to_next(const Simulation& simulation) const {
  std::int64_t steps = 1;
  while (!due_at(simulation.steps() + steps, simulation.deck()).anything()) ++steps;
  return steps;
}

void Recorder::steps_done(const Simulation& simulation, const Phase& phase) {
  const std::int64_t step = simulation.steps();
  const Due due = due_at(step, simulation.deck());
  particle_steps_ += static_cast<double>((step - counted_steps_) * inside_);
  counted_steps_ = step;
  if (due.anything()) simulation.check_guards();  // no bad state gets into a file
  if (due.trace) write_trace(simulation);
  if (due.check) {
    inside_ = inside(simulation);
    for (const Watched& w : watches_) w.watch->look(simulation);
    report_progress(simulation, phase);
  }
  if (due.series) write_series_row(simulation, phase.deck().name);
  for (const Watched& w : watches_) {
    if (w.watch->is_due(step)) w.watch->sample(simulation);
  }
  if (due.snapshot) write_snapshot_now(simulation);
}

void Recorder::phase_ended(const Simulation& simulation, const Phase& phase, const std::string& ended_by) {
  settled_steps_ += longest_steps(phase.deck(), simulation.time_step().step);
  phases_.push_back({phase.deck().name, phase.steps_done(simulation), ended_by});
  for (const Watched& w : watches_) w.watch->phase_ends(simulation);
  if (simulation.comm().is_root()) {
    options_.log.say(fmt::format("phase {} ended by {} at {:.6g} s after {} steps", phase.deck().name, ended_by,
                                 simulation.time(), phase.steps_done(simulation)));
    if (phase.steps_done(simulation) == 0) {
      options_.log.warn(
          fmt::format("phase {} ended before its first step: {}", phase.deck().name, reason_of_no_step(ended_by)));
    }
  }
}

bool Recorder::has_seen(PhaseUntil condition) const {
  return std::any_of(watches_.begin(), watches_.end(), [&](const Watched& w) { return w.watch->has_seen(condition); });
}

void Recorder::write_series_row(const Simulation& simulation, const std::string& phase) {
  if (simulation.steps() == last_series_) return;
  last_series_ = simulation.steps();
  const Communicator& comm = simulation.comm();
  const Energies e =
      measure_energies(comm, simulation.scene().gravity(), simulation.materials(), simulation.particles(),
                       simulation.pairs(), simulation.walls(), simulation.wall_contacts());
  const ContactCount contacts =
      count_contacts(comm, simulation.particles(), simulation.pairs(), simulation.walls(), simulation.wall_contacts());
  const std::int64_t particles = inside(simulation);
  const double discharged = simulation.deck().discharge.enabled ? discharged_mass_of(simulation) : 0.0;
  const auto& phases = simulation.deck().phases;
  const auto at = std::find_if(phases.begin(), phases.end(), [&](const PhaseDeck& p) { return p.name == phase; });
  std::vector<TimeSeries::Value> row = {
      simulation.steps(), simulation.time(), static_cast<std::int64_t>(at - phases.begin()),
      particles,          contacts.pairs,    contacts.walls,
      e.translational,    e.rotational,      e.gravitational,
      e.elastic,          discharged};
  if (simulation.heat() != nullptr) {
    const HeatFigures heat = measure_heat(comm, simulation.materials(), *simulation.heat(), simulation.particles());
    row.insert(row.end(), {heat.stored, heat.mean, heat.lowest, heat.highest});
  }
  for (const std::int64_t mass : sum_of(comm, simulation.left_here()).named_mass) {
    row.emplace_back(simulation.mass_unit().kilograms(mass));
  }
  agree_after_root(comm, [&] { series_->append(row); });
  if (wall_loads_) wall_loads_->write(simulation);
}

void Recorder::write_trace(const Simulation& simulation) {
  const ParticleTable table =
      collect_particles(simulation.comm(), simulation.materials(), simulation.particles(), simulation.planned());
  const std::vector<TraceRow> rows = gather_trace_rows(simulation.comm(), table);
  agree_after_root(simulation.comm(), [&] { trace_->append(simulation.steps(), rows); });
}

/// One line every few wall seconds; rank 0's clock decides for all, since the line needs sums over the ranks.
void Recorder::report_progress(const Simulation& simulation, const Phase& phase) {
  const Communicator& comm = simulation.comm();
  const double elapsed = seconds_since(last_progress_);
  int due = elapsed >= simulation.deck().output.progress_seconds ? 1 : 0;
  if (options_.log.progress == nullptr) due = 0;
  comm.broadcast(due);
  if (due == 0) return;
  ProgressState state;
  state.step = simulation.steps();
  state.time_s = simulation.time();
  const std::int64_t done = settled_steps_ + phase.steps_done(simulation);
  state.share_done = static_cast<double>(done) / static_cast<double>(total_steps_);
  state.phase = phase.deck().name;
  state.particles = inside_;
  const ContactCount contacts =
      count_contacts(comm, simulation.particles(), simulation.pairs(), simulation.walls(), simulation.wall_contacts());
  state.contacts = contacts.pairs + contacts.walls;
  state.kinetic_energy_j = mean_kinetic_energy(comm, simulation.materials(), simulation.particles());
  const double rate = static_cast<double>(simulation.steps() - last_progress_step_) / elapsed;
  state.particle_steps_per_second = rate * static_cast<double>(inside_);
  state.imbalance = simulation.counters().imbalance;
  if (rate > 0.0) state.seconds_left = static_cast<double>(total_steps_ - done) / rate;
  if (comm.is_root()) options_.log.say(progress_line(state));
  last_progress_ = WallClock::now();
  last_progress_step_ = simulation.steps();
}

}  // namespace repose
