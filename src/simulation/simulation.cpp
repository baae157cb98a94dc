#include "simulation/simulation.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "base/error.h"
#include "integration/velocity_verlet.h"
#include "measurement/wall_resistance.h"
#include "scene/walls/periodic_walls.h"
#include "simulation/contact_alarm.h"
#include "simulation/guards.h"
#include "simulation/setup.h"

namespace repose {
namespace {

void append_particle(const NewParticles& from, std::size_t i, Particles& to) {
  to.record.push_back(
      {to.periodic.on_grid(from.position[i]), from.radius[i], from.velocity[i], 0.0, from.spin[i], 0.0});
  to.id.push_back(from.id[i]);
  to.material.push_back(from.material[i]);
}

}  // namespace

Simulation::Simulation(const Communicator& comm, const Deck& deck, const ReadFile& read_file, VectorLevel level)
    : comm_(comm),
      deck_(deck),
      level_(level),
      materials_(deck),
      scene_(deck, make_walls(deck, materials_, read_file)),
      decomposition_(comm.size()),
      ghosts_(comm),
      load_(comm) {
  particles_.periodic = Periodicity(deck_.domain);
  particles_.has_heat = deck_.heat.enabled;
  open_domain_ = particles_.periodic.open_bounds(deck_.domain);
  left_ = ExitCount::none(deck_.exits.size());
  auto [insertion, time_step, smallest, growth, heat, reach] = set_up(deck_, materials_, walls(), read_file);
  scene_.hold(deck_, insertion);
  time_step_ = time_step;
  slow_step_ = greatest_speed(time_step_, greatest_excess) * time_step_.step / std::sqrt(3.0);
  safe_step_ = longest_way / std::sqrt(3.0) * smallest;
  if (heat) heat_.emplace(std::move(*heat));
  const auto horizon = [&](std::int64_t steps) { return static_cast<double>(steps) * time_step_.step; };
  watch_ = SkinWatch(
      {deck_.neighbours.inner_skin, horizon(ListHorizon::inner), 0.5 * reach.longest_skin, reach.adhesion_range},
      {deck_.neighbours.skin, horizon(ListHorizon::choices.front()), reach.longest_skin, reach.adhesion_range,
       reach.heat_share});
  scene_.set_wall_skins(deck_, watch_.inner().horizon, watch_.outer().horizon);
  planned_ = insertion.planned;
  mass_unit_ = MassUnit(planned_mass(insertion, materials_) * growth * growth * growth);
  sizes_ = std::move(insertion.sizes);
  pouring_ = Pouring(std::move(insertion.pours), time_step_.step);
  insert(insertion.now);
  check_guards();
  rebuild_lists();
  evaluate_forces(0.0);
  check_guards();
  clock_ = {};  // the set-up belongs to no stage
  load_ = RankLoad(comm_);
}

/// Each rank starts with an equal share of the particles; the first rebuild sends them where they belong.
void Simulation::insert(const NewParticles& all) {
  inserted_at_start_ = static_cast<std::int64_t>(all.size());
  const auto ranks = static_cast<std::size_t>(comm_.size());
  const auto rank = static_cast<std::size_t>(comm_.rank());
  for (std::size_t i = all.size() * rank / ranks; i < all.size() * (rank + 1) / ranks; ++i) {
    append_particle(all, i, particles_);
    if (heat_) heat_->enter(all.temperature.empty() ? unset : all.temperature[i], particles_);
  }
  particles_.owned = particles_.id.size();
}

void Simulation::advance(std::int64_t steps) {
  const double dt = time_step_.step;
  for (std::int64_t k = 0; k < steps;) {
    if (moves_) {
      move(k++, dt);
    } else {
      k += stand_still(steps - k);
    }
    if (heat_ && steps_ % heat_->every() == 0) advance_heat();
  }
  if (moves_) {
    clock_.enter(Stage::integration);
    step_second_half(level_, scene_.gravity(), dt, particles_);
    scene_.put_back(particles_);
  }
  clock_.enter(Stage::output);
}

void Simulation::begin_phase(const std::string& name) {
  scene_.begin_phase(name);
  const auto found =
      std::find_if(deck_.phases.begin(), deck_.phases.end(), [&](const PhaseDeck& p) { return p.name == name; });
  const PhaseDeck phase = found == deck_.phases.end() ? PhaseDeck{} : *found;
  moves_ = phase.mechanics;
  if (!moves_) scene_.place(time_step_.step);  // with the motions of this phase, as no step will
  growth_ = phase.growth;
  if (heat_) heat_->set_boxes(phase.heat);
}

void Simulation::set_wall_present(const std::string& name, bool present) {
  scene_.set_wall_present(name, present);
  for (std::size_t w = 0; w < walls().size(); ++w) {
    if (!walls()[w].present) wall_contacts_.forget(static_cast<std::int32_t>(w));
  }
}

void Simulation::warm() {
  if (heat_) heat_->warm(particles_);
}

/// At most so many steps in which nothing moves, up to the next thermal one. How many it were.
std::int64_t Simulation::stand_still(std::int64_t most) {
  const std::int64_t to_heat = heat_->every() - steps_ % heat_->every();
  const std::int64_t steps = std::min(most, to_heat);
  if (const std::int64_t pours = pouring_.next_step(); pours <= steps_ + steps) {
    throw PhysicsError(fmt::format(
        "step {}: particles are to be poured in a phase without mechanics, where none can enter; let the pour end "
        "before it, or begin after it",
        pours));
  }
  steps_ += steps;
  return steps;
}

/// The k-th step of a call of advance.
void Simulation::move(std::int64_t k, double dt) {
  clock_.begin_step();
  clock_.enter(Stage::integration);
  const auto halves = k == 0 ? step_first_half : step_second_and_first_half;
  const StepNotes notes = halves(level_, scene_.gravity(), dt, open_domain_, watch_.inner_marks(), moved_, particles_);
  const bool may_be_unfit = notes.nowhere || notes.longest_step >= safe_step_;
  if (may_be_unfit && !alarm_) alarm_ = find_unfit(guard_view(steps_ + 1));
  if (notes.longest_step >= slow_step_ && !alarm_) alarm_ = find_too_fast(guard_view(steps_ + 1), time_step_);
  scene_.step(dt, particles_);
  const bool any_leaves = notes.outside > parked_ || scene_.held().is_any_outside(open_domain_, particles_);
  if (any_leaves && !alarm_) count_leavers();
  const std::span<const std::int32_t> moved = find_moved(notes.moved);
  const bool outer_used_up = agree_on_rebuild(moved);
  const bool enter = steps_ + 1 == pouring_.next_step() && pour();
  const bool grows = growth_.enabled && (steps_ + 1) % growth_.every == 0;
  if (grows) grow();
  clock_.enter(Stage::lists);
  if (enter || grows || outer_used_up) {
    rebuild_lists();
  } else {
    renew_outer_skins();
    renew_inner_lists(moved);
    clock_.enter(Stage::ghosts);
    ghosts_.start(particles_);
    ghosts_on_their_way_ = true;
  }
  evaluate_forces(dt);
  load_.count_step(pairs_.lanes(), particles_.ghosts());
  ++steps_;
  control_servos();
}

/// The walls under load look at their forces, with the velocities of half a step ago however the steps are called.
void Simulation::control_servos() {
  for (std::size_t w = 0; w < walls().size(); ++w) {
    if (!scene_.is_servo_due(w, steps_)) continue;
    clock_.enter(Stage::wall_contacts);
    const double interval = static_cast<double>(walls()[w].servo->every()) * time_step_.step;
    const PressingWall pressing{static_cast<std::int32_t>(w), interval, deck_.guards.max_overlap};
    const WallResistance grains =
        measure_resistance(comm_, level_, pressing, walls(), materials_, particles_, wall_contacts_);
    if (const auto told = scene_.control(w, grains, time_step_.step)) warn(fmt::format("step {}: {}", steps_, *told));
  }
}

void Simulation::warn(const std::string& what) { warning_ = warning_ ? *warning_ + "; " + what : what; }

void Simulation::advance_heat() {
  clock_.enter(Stage::heat);
  const auto every = static_cast<double>(heat_->every());
  const HeatScene scene{comm_, ghosts_, pairs_, wall_contacts_, walls(), time(), every * time_step_.step};
  const std::optional<HeatFault> fault = heat_->advance(scene, particles_);
  if (!fault || alarm_) return;
  alarm_ = alarm_at(guard_view(steps_), fault->particle, particles_.position(fault->particle),
                    fmt::format("particle {} at {}: {}", particles_.id[fault->particle],
                                place_text(particles_.position(fault->particle)), fault->what));
}

/// Whether particles enter at this step.
bool Simulation::pour() {
  clock_.enter(Stage::lists);
  entering_ = pouring_.enter(comm_, {steps_ + 1, deck_.run.seed, scene_.gravity()}, particles_, walls());
  return entering_.size() > 0;
}

/// All particles but held ones become larger; their masses follow when the lists are made anew.
void Simulation::grow() {
  const double mass_factor = growth_.factor * growth_.factor * growth_.factor;
  for (std::size_t i = 0; i < particles_.owned; ++i) {
    if (materials_.is_held(particles_.material[i])) continue;
    particles_.record[i].radius *= growth_.factor;
    if (heat_) heat_->multiply(mass_factor, i, particles_);
  }
}

/// Adds the particles that enter to those of the rank whose part of the domain they are in, without contacts.
void Simulation::admit(ContactMemory& memory) {
  if (entering_.size() == 0) return;
  particles_.record.resize(particles_.owned);  // the ghosts and dummies are of the old lists
  particles_.id.resize(particles_.owned);
  particles_.material.resize(particles_.owned);
  for (std::size_t i = 0; i < entering_.size(); ++i) {
    if (decomposition_.owner(entering_.position[i]) != comm_.rank()) continue;
    append_particle(entering_, i, particles_);
    if (heat_) heat_->enter(unset, particles_);
    memory.pairs.append_row({});
    memory.walls.append_row({});
  }
  particles_.owned = particles_.id.size();
  entering_ = {};
}

bool Simulation::awaits_particles() const {
  return pouring_.is_under_way(steps_) || (inserted() == 0 && !pouring_.is_complete());
}

void Simulation::count_leavers() {
  retire_leavers(open_domain_, deck_.exits, materials_, mass_unit_, particles_, left_);
  if (heat_) heat_->take_leavers(particles_);
  watch_.ignore_parked(particles_);
  parked_ = 0;
  for (std::size_t i = 0; i < particles_.owned; ++i) parked_ += is_parked(particles_.record[i]) ? 1U : 0U;
}

/// The criteria of the time step with the true greatest speed, with one warning in all.
void Simulation::check_time_step() {
  const std::int64_t step = counters_.rebuilds == 0 ? steps_ : steps_ + 1;
  const std::optional<std::size_t> fastest = fastest_particle(particles_);
  checked_speed_ = std::max(time_step_.speed, fastest ? norm(particles_.record[*fastest].velocity) : 0.0);
  const bool at_start = counters_.rebuilds == 0 && steps_ == 0;
  if (at_start) throw_if_any(comm_, find_too_fast(guard_view(step), time_step_));
  if (warned_of_time_step_) return;
  const std::optional<std::string> warning = warning_of_time_step(comm_, guard_view(step), time_step_, fastest);
  if (!warning) return;
  warned_of_time_step_ = true;
  warn(*warning);
}

GuardView Simulation::guard_view(std::int64_t step) const {
  return {particles_, materials_, watch_.inner_marks(), step, time_step_.step};
}

void Simulation::evaluate_forces(double dt) {
  const double max_overlap = deck_.guards.max_overlap;
  bool alarm = false;
  const auto evaluate = [&](bool interior) {
    for (PairGroup& group : pairs_.groups()) {
      if (group.interior == interior) alarm |= evaluate_group(group, dt);
    }
  };
  clock_.enter(Stage::pair_contacts);
  evaluate(true);
  clock_.enter(Stage::wall_contacts);
  alarm |= wall_contacts_.evaluate(level_, walls(), materials_, dt, max_overlap, particles_).any();
  clock_.enter(Stage::ghosts);
  if (ghosts_on_their_way_) {
    ghosts_.finish(particles_);
    ghosts_on_their_way_ = false;
    clock_.enter(Stage::lists);
    renew_skins(watch_.moved_ghosts(particles_));
  }
  clock_.enter(Stage::pair_contacts);
  evaluate(false);
  if (alarm && !alarm_) {
    alarm_ = contact_alarm(guard_view(dt > 0.0 ? steps_ + 1 : steps_),
                           {pairs_, wall_contacts_, walls(), level_, max_overlap});
  }
  if (!alarm_) alarm_ = find_full_sum(guard_view(dt > 0.0 ? steps_ + 1 : steps_), crowded_);
}

/// In pieces, between which the messages of the ghosts advance. Whether there was an alarm.
bool Simulation::evaluate_group(PairGroup& group, double dt) {
  constexpr std::size_t piece = 512;  // blocks: some 0.2 ms
  const PairParameters& pair =
      materials_.pair(static_cast<std::size_t>(group.material_first), static_cast<std::size_t>(group.material_second));
  const std::span<ContactBlock> blocks = group.blocks;
  bool alarm = false;
  for (std::size_t first = 0; first < blocks.size(); first += piece) {
    const std::size_t count = std::min(piece, blocks.size() - first);
    alarm |= evaluate_pairs(level_, blocks.subspan(first, count), pair, dt, deck_.guards.max_overlap,
                            particles_.record.data(), particles_.sum.data())
                 .any();
    if (ghosts_on_their_way_) ghosts_.advance();
  }
  return alarm;
}

void Simulation::check_guards() const { throw_if_any(comm_, alarm_ ? alarm_ : find_unfit(guard_view(steps_))); }

std::size_t Simulation::memory_bytes() const {
  return particles_.bytes() + pairs_.bytes() + wall_contacts_.bytes() + watch_.bytes() + partner_search_.bytes();
}

std::optional<std::string> Simulation::take_warning() {
  std::optional<std::string> warning;
  std::swap(warning, warning_);
  return warning;
}

}  // namespace repose
