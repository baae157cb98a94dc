#include "simulation.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/error.h"
#include "domain/migration.h"
#include "guards.h"
#include "integration/velocity_verlet.h"
#include "scene/sphere.h"
#include "setup.h"

namespace repose {
namespace {

constexpr double inner_horizon_steps = 32.0;   // steps at present speed that the inner skin covers
constexpr double outer_horizon_steps = 320.0;  // the same of the outer skin

}  // namespace

Simulation::Simulation(const Communicator& comm, const Deck& deck, const ReadFile& read_file, VectorLevel level)
    : comm_(comm),
      deck_(deck),
      level_(level),
      materials_(deck),
      walls_(make_walls(deck, materials_, read_file)),
      decomposition_(comm.size()),
      ghosts_(comm) {
  const NewParticles all = insert_particles(deck_, walls_, read_file);
  time_step_ = choose_time_step(deck_, materials_, smallest_radii(all, materials_.size()), expected_speed(deck_, all));
  watch_ = SkinWatch({deck_.neighbours.inner_skin, inner_horizon_steps * time_step_.step},
                     {deck_.neighbours.skin, outer_horizon_steps * time_step_.step});
  insert(all);
  rebuild_lists();
  evaluate_forces(0.0);
  check_guards();
  clock_ = {};  // the set-up belongs to no stage
}

/// Each rank starts with an equal share of the ids; the first rebuild sends the particles where they belong.
void Simulation::insert(const NewParticles& all) {
  inserted_ = static_cast<std::int64_t>(all.size());
  double total_mass = 0.0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    total_mass += sphere_mass(all.radius[i], materials_[static_cast<std::size_t>(all.material[i])].density);
  }
  mass_unit_ = MassUnit(total_mass);
  const auto ranks = static_cast<std::size_t>(comm_.size());
  const auto rank = static_cast<std::size_t>(comm_.rank());
  for (std::size_t i = all.size() * rank / ranks; i < all.size() * (rank + 1) / ranks; ++i) {
    particles_.record.push_back({all.position[i], all.radius[i], all.velocity[i], 0.0, all.spin[i], 0.0});
    particles_.id.push_back(static_cast<std::int64_t>(i));
    particles_.material.push_back(all.material[i]);
  }
  particles_.owned = particles_.id.size();
}

void Simulation::advance(std::int64_t steps) {
  const double dt = time_step_.step;
  for (std::int64_t k = 0; k < steps; ++k) {
    clock_.enter(Stage::integration);
    const auto halves = k == 0 ? step_first_half : step_second_and_first_half;
    const StepNotes notes = halves(level_, deck_.gravity, dt, deck_.domain, watch_.inner_marks(), particles_);
    if (notes.outside > parked_) count_leavers(notes.outside);
    renew_lists(agreed_list_state(notes.skin_used_up));
    evaluate_forces(dt);
    ++steps_;
  }
  clock_.enter(Stage::integration);
  step_second_half(level_, deck_.gravity, dt, particles_);
  clock_.enter(Stage::output);
}

/// Lists that hold every contact of this step, and the ghosts on their way.
void Simulation::renew_lists(ListState state) {
  switch (state) {
    case ListState::outer_stale:
      clock_.enter(Stage::lists);
      rebuild_lists();
      break;
    case ListState::inner_stale:
      clock_.enter(Stage::ghosts);
      ghosts_.start(particles_);
      ghosts_.finish(particles_);
      clock_.enter(Stage::lists);
      select_near();
      ++counters_.inner_selections;
      break;
    case ListState::valid:
      clock_.enter(Stage::ghosts);
      ghosts_.start(particles_);
      ghosts_on_their_way_ = true;
      break;
  }
}

void Simulation::select_near() {
  pairs_.select_near(particles_, watch_.inner());
  wall_contacts_.select_near(particles_, walls_, watch_.inner());
  watch_.inner_selected(particles_);
}

void Simulation::count_leavers(std::size_t outside) {
  retire_leavers(deck_.domain, materials_, mass_unit_, particles_, left_);
  watch_.ignore_parked(particles_);
  parked_ = outside;
}

/// What the lists need, agreed among the ranks together with whether any raised an alarm. A second reduction only when
/// an inner list has to be made anew.
Simulation::ListState Simulation::agreed_list_state(bool inner_used_up) {
  constexpr int moved = 1;
  constexpr int alarmed = 2;
  const int here = !alarm_.empty() ? alarmed : inner_used_up ? moved : 0;
  clock_.enter(Stage::agreement);
  const int worst = comm_.size() == 1 ? here : comm_.max(here);
  if (worst == alarmed) check_guards();
  if (worst == 0) return ListState::valid;
  const int short_here = watch_.outer_is_too_short(particles_) ? 1 : 0;
  return comm_.max(short_here) != 0 ? ListState::outer_stale : ListState::inner_stale;
}

void Simulation::rebuild_lists() {
  ContactMemory memory = {pairs_.memory(particles_), wall_contacts_.memory(particles_.owned)};
  if (memory.pairs.rows() != particles_.owned) throw std::logic_error("contact memory does not match the particles");
  balance();
  pairs_.clear();  // a large bed has no room for the old lists beside the new ones
  migrate(comm_, decomposition_, particles_, memory);
  set_fixed_point_scales(materials_, deck_.guards.max_overlap, particles_);
  check_time_step();
  const std::vector<double> reach = ghosts_.set_up(decomposition_, watch_.outer(), particles_);
  std::vector<IndexPair> near = near_pairs(particles_.record, reach, particles_.owned);
  const std::vector<bool> needed = ghosts_in(near, particles_.owned, particles_.total());
  ghosts_.keep(needed, particles_);
  drop_ghosts(needed, particles_.owned, near);
  add_lane_dummies(particles_);
  pairs_.build(particles_, near, memory.pairs);
  near = {};
  wall_contacts_.build(particles_, walls_, reach, memory.walls);
  memory = {};
  watch_.outer_listed(particles_);
  select_near();
  parked_ = 0;
  ++counters_.rebuilds;
}

/// A new decomposition when the busiest rank has more than its share, measured in counted particles and pairs.
void Simulation::balance() {
  if (comm_.size() == 1) return;
  constexpr std::int64_t particle_cost = 2;  // in units of a listed pair
  std::vector<std::int64_t> cost = pairs_.pairs_of_owned(particles_);
  std::vector<Vec3> positions;
  std::vector<std::int64_t> alive_cost;
  std::int64_t here = 0;
  for (std::size_t i = 0; i < particles_.owned; ++i) {
    if (is_parked(particles_.record[i])) continue;
    positions.push_back(particles_.record[i].position);
    alive_cost.push_back(particle_cost + cost[i]);
    here += alive_cost.back();
  }
  const std::int64_t total = comm_.sum(here);
  const std::int64_t busiest = comm_.max(here);
  counters_.imbalance = total > 0 ? static_cast<double>(busiest) * comm_.size() / static_cast<double>(total) : 1.0;
  const bool first = counters_.rebuilds == 0;
  if (!first && counters_.imbalance <= deck_.neighbours.max_imbalance) return;
  decomposition_ = Decomposition::bisect(comm_, positions, alive_cost);
  ++counters_.bisections;
}

/// The criteria of the time step with the true greatest speed: one warning beyond the fraction, an error beyond twice.
void Simulation::check_time_step() {
  double fastest = 0.0;
  for (std::size_t i = 0; i < particles_.owned; ++i) fastest = std::max(fastest, norm(particles_.record[i].velocity));
  fastest = comm_.max(fastest);
  const double excess = time_step_excess(time_step_, fastest);
  if (excess > 2.0) {
    throw PhysicsError(fmt::format(
        "step {}: a particle moves at {:.3g} m/s, for which the time step {:.3g} s is {:.2g} times its criterion; "
        "set time.expected_speed to {:.3g} or shorten time.step",
        steps_, fastest, time_step_.step, excess, fastest));
  }
  if (excess > 1.0 + 1e-9 && !warned_of_time_step_) {
    warned_of_time_step_ = true;
    warning_ = fmt::format(
        "step {}: at {:.3g} m/s the time step {:.3g} s is {:.2f} times its criterion (expected {:.3g} m/s; an error at "
        "2)",
        steps_, fastest, time_step_.step, excess, time_step_.speed);
  }
}

void Simulation::evaluate_forces(double dt) {
  const double max_overlap = deck_.guards.max_overlap;
  bool alarm = false;
  const auto evaluate = [&](bool interior) {
    for (PairGroup& group : pairs_.groups()) {
      if (group.interior != interior) continue;
      const PairParameters& pair = materials_.pair(static_cast<std::size_t>(group.material_first),
                                                   static_cast<std::size_t>(group.material_second));
      alarm |= evaluate_pairs(level_, group.blocks, group.fetch, pair, dt, max_overlap, particles_.record.data(),
                              particles_.sum.data())
                   .any();
    }
  };
  clock_.enter(Stage::pair_contacts);
  evaluate(true);
  clock_.enter(Stage::wall_contacts);
  alarm |= wall_contacts_.evaluate(level_, walls_, materials_, dt, max_overlap, particles_).any();
  clock_.enter(Stage::ghosts);
  if (ghosts_on_their_way_) ghosts_.finish(particles_);
  ghosts_on_their_way_ = false;
  clock_.enter(Stage::pair_contacts);
  evaluate(false);
  if (alarm && alarm_.empty()) {
    alarm_ = describe_alarm(particles_, pairs_, wall_contacts_, walls_, max_overlap, dt > 0.0 ? steps_ + 1 : 0);
  }
}

void Simulation::check_guards() const {
  const int none = comm_.size();
  const int first = comm_.min(alarm_.empty() ? none : comm_.rank());
  if (first == none) return;
  std::string message = alarm_;
  comm_.broadcast(message, first);
  throw PhysicsError(message);
}

std::size_t Simulation::memory_bytes() const {
  return particles_.bytes() + pairs_.bytes() + wall_contacts_.bytes() + watch_.bytes();
}

void Simulation::set_wall_present(const std::string& name, bool present) {
  const auto wall = std::find_if(walls_.begin(), walls_.end(), [&](const Wall& w) { return w.name == name; });
  if (wall != walls_.end()) wall->present = present;
}

std::optional<std::string> Simulation::take_warning() {
  std::optional<std::string> warning;
  std::swap(warning, warning_);
  return warning;
}

}  // namespace repose
