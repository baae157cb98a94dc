#include "simulation/simulation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/core.h>

#include "contact/adhesion_range.h"
#include "domain/migration.h"
#include "integration/velocity_verlet.h"
#include "measurement/wall_resistance.h"
#include "simulation/contact_alarm.h"
#include "simulation/guards.h"
#include "simulation/setup.h"

namespace repose {
namespace {

constexpr std::int64_t inner_horizon_steps = ListHorizon::inner;            // that the inner skin covers
constexpr std::int64_t outer_horizon_steps = ListHorizon::choices.front();  // the most that the outer skin covers

/// Inner lists are chosen anew for all particles once so many have begun new skins alone: by then the lists have pairs
/// that are no longer near, out of order.
std::size_t most_renewed(std::size_t owned) { return 16 + owned / 32; }

/// Outer lists are made anew for all particles once so many have begun outer skins alone: by then the lists have pairs
/// far apart, out of order, and the search for partners looks through all those one by one. Each may bring a pair to a
/// particle that was not crowded.
std::size_t most_outer_renewed(std::size_t owned) { return std::min(16 + owned / 16, crowd); }

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
  Insertion insertion = insert_particles_of(deck_, walls(), read_file);
  scene_.hold(deck_, insertion);
  const SmallestRadii radii = smallest_radii(insertion, materials_.size());
  time_step_ = choose_time_step(deck_, materials_, radii, expected_speed(deck_, insertion.now, insertion.pours));
  check_wall_speeds(deck_, walls(), materials_, radii, time_step_.step);
  const double smallest = *std::min_element(radii.of_material.begin(), radii.of_material.end());
  const double growth = greatest_growth(deck_, time_step_.step);
  const double mass_growth = growth * growth * growth;
  const double largest = growth * insertion.largest_radius();
  const double adhesion_range = longest_holding_distance(materials_, smallest, largest);
  safe_step_ = longest_way / std::sqrt(3.0) * smallest;
  if (deck_.heat.enabled) heat_.emplace(deck_, materials_, insertion, mass_growth);
  const double heat_share = heat_ ? heat_->state().conductance().reach_share() : 0.0;
  const double longest = longest_skin(particles_.periodic, largest * (1.0 + heat_share) + adhesion_range);
  const auto horizon = [&](std::int64_t steps) { return static_cast<double>(steps) * time_step_.step; };
  watch_ = SkinWatch({deck_.neighbours.inner_skin, horizon(inner_horizon_steps), 0.5 * longest, adhesion_range},
                     {deck_.neighbours.skin, horizon(outer_horizon_steps), longest, adhesion_range, heat_share});
  scene_.set_wall_skins(deck_, watch_.inner().horizon, watch_.outer().horizon);
  planned_ = insertion.planned;
  mass_unit_ = MassUnit(planned_mass(insertion, materials_) * mass_growth);
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
  growth_ = phase.growth;
  if (heat_) heat_->set_boxes(phase.heat);
}

void Simulation::warm() {
  if (heat_) heat_->warm(particles_);
}

/// At most so many steps in which nothing moves, up to the next thermal one. How many it were.
std::int64_t Simulation::stand_still(std::int64_t most) {
  const std::int64_t to_heat = heat_->every() - steps_ % heat_->every();
  const std::int64_t steps = std::min(most, to_heat);
  const std::int64_t pours = pouring_.next_step();
  if (pours > steps_ && pours <= steps_ + steps && !alarm_ && particles_.owned > 0) {
    alarm_ = alarm_at(guard_view(pours), 0, particles_.position(0),
                      "particles are to be poured in a phase without mechanics, where none can enter");
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
  scene_.step(dt, particles_);
  if (notes.outside > parked_ && !alarm_) count_leavers();
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
    const WallResistance grains = measure_resistance(comm_, level_, {static_cast<std::int32_t>(w), interval}, walls(),
                                                     materials_, particles_, wall_contacts_);
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

/// Inner lists that hold every contact of this step, but for those of ghosts that are still on their way: theirs are
/// renewed when they are here.
void Simulation::renew_inner_lists(std::span<const std::int32_t> moved) {
  const bool too_old = scene_.walls_travel() && steps_ + 1 - inner_selected_at_ >= inner_horizon_steps;
  if (too_old || renewed_skins_ + moved.size() > most_renewed(particles_.owned)) {
    select_near();
    ++counters_.inner_selections;
    return;
  }
  renew_skins(moved);
  wall_contacts_.search(moved);
}

/// Lets the inner skins of these particles, owned or ghosts, begin anew, with the pairs that this brings near.
void Simulation::renew_skins(std::span<const std::int32_t> moved) {
  watch_.begin_inner(particles_, moved);
  pairs_.add_near(watch_.inner_spheres(), moved);
  renewed_skins_ += moved.size();
}

void Simulation::select_near() {
  watch_.begin_inner(particles_);
  pairs_.select_near(watch_.inner_spheres());
  wall_contacts_.select_near(particles_, walls(), watch_.inner());
  inner_selected_at_ = steps_;
  renewed_skins_ = 0;
}

void Simulation::count_leavers() {
  retire_leavers(open_domain_, deck_.exits, materials_, mass_unit_, particles_, left_);
  if (heat_) heat_->take_leavers(particles_);
  watch_.ignore_parked(particles_);
  parked_ = 0;
  for (std::size_t i = 0; i < particles_.owned; ++i) parked_ += is_parked(particles_.record[i]) ? 1U : 0U;
}

/// The particles whose inner skins are used up: the first `moved` of moved_, and held ones. Parked ones do not count.
std::span<const std::int32_t> Simulation::find_moved(std::size_t moved) {
  moved += scene_.held().find_moved(watch_.inner_marks(), particles_, std::span(moved_).subspan(moved));
  const auto end = moved_.begin() + static_cast<std::ptrdiff_t>(moved);
  const auto kept = std::remove_if(
      moved_.begin(), end, [&](std::int32_t i) { return is_parked(particles_.record[static_cast<std::size_t>(i)]); });
  return {moved_.begin(), kept};
}

/// Whether a particle of any rank has nothing left of its outer skin, which cannot begin anew alone, or walls of
/// theirs; agreed together with whether any rank raised an alarm.
bool Simulation::agree_on_rebuild(std::span<const std::int32_t> moved) {
  constexpr int used_up = 1;
  constexpr int alarmed = 2;
  const bool too_old =
      scene_.walls_travel() && steps_ + 1 - outer_listed_at_ > outer_horizon_steps - inner_horizon_steps;
  clock_.enter(Stage::lists);
  const int here = alarm_ ? alarmed : too_old || !can_renew_outer_skins(moved) ? used_up : 0;
  clock_.enter(Stage::agreement);
  const int worst = comm_.size() == 1 ? here : comm_.max(here);
  if (worst == alarmed) check_guards();
  return worst != 0;
}

/// Finds who of these has nothing left of its outer skin, and whether all those can begin a new one alone. Held ones,
/// and those that gather speed, for which the criteria of the time step are to be looked at again, cannot.
bool Simulation::can_renew_outer_skins(std::span<const std::int32_t> moved) {
  constexpr double most_faster = 1.25;  // 1.05 times the Hertz criterion
  at_large_.clear();
  for (const std::int32_t moved_one : moved) {
    const auto i = static_cast<std::size_t>(moved_one);
    if (!watch_.outer_is_used_up(particles_, i)) continue;
    if (materials_.is_held(particles_.material[i])) return false;
    if (norm(particles_.record[i].velocity) > most_faster * checked_speed_) return false;
    if (!ghosts_.is_alone(decomposition_, particles_, i, reach_of(particles_.record[i], watch_.outer()))) return false;
    at_large_.push_back(moved_one);
  }
  return partner_search_.renewals() + at_large_.size() <= most_outer_renewed(particles_.owned);
}

/// Lets the outer skins of the particles at large begin anew, with the pairs and walls that this brings near. Their
/// inner ones are used up as well, and follow.
void Simulation::renew_outer_skins() {
  for (const std::int32_t i : at_large_) watch_.begin_outer(particles_, static_cast<std::size_t>(i));
  partner_search_.renew(particles_, watch_, at_large_);
  for (const std::int32_t i : at_large_) {
    const std::span<const std::int32_t> partners = partner_search_.partners(particles_, watch_, i);
    if (partners.size() >= crowd) crowded_.push_back(i);
    pairs_.list_more(particles_, i, partners);
    wall_contacts_.list_more(particles_, walls(), i,
                             watch_.outer_sphere(particles_, static_cast<std::size_t>(i)).reach);
  }
  counters_.outer_renewals += static_cast<std::int64_t>(at_large_.size());
}

void Simulation::rebuild_lists() { rebuild_lists(contact_memory()); }

void Simulation::rebuild_lists(ContactMemory memory) {
  wrap_positions(particles_);
  if (memory.pairs.rows() != particles_.owned) throw std::logic_error("contact memory does not match the particles");
  balance();
  pairs_.clear();
  admit(memory);
  migrate(comm_, decomposition_, particles_, memory);
  set_fixed_point_scales(materials_, deck_.guards.max_overlap, particles_);
  scene_.list_held(particles_);
  check_time_step();
  choose_horizons();
  std::vector<double> reach = ghosts_.set_up(decomposition_, watch_.outer(), particles_);
  std::vector<CellLevel> levels = sort_into_levels(particles_.record, reach);
  std::vector<IndexPair> near = near_pairs(levels, particles_.record, reach, particles_.owned);
  ignore_held(near, reach);
  const std::vector<bool> needed = ghosts_in(near, particles_.owned, particles_.total());
  ghosts_.keep(needed, particles_);
  drop_ghosts(needed, particles_.owned, near);
  crowded_ = crowded_particles(near, particles_.owned);
  add_lane_dummies(particles_);
  pairs_.build(particles_, near, memory.pairs);
  near = {};
  wall_contacts_.build(particles_, walls(), reach, memory.walls);
  memory = {};
  watch_.begin_outer(particles_);
  partner_search_.begin(std::move(levels), particles_.owned);
  outer_listed_at_ = steps_;
  outer_listed_ = pairs_.listed();
  moved_.resize(particles_.owned + scene_.held().listed());
  select_near();
  parked_ = 0;
  ++counters_.rebuilds;
  counters_.peak_ghosts = std::max(counters_.peak_ghosts, static_cast<std::int64_t>(particles_.ghosts()));
}

/// Held particles feel neither one another nor walls.
void Simulation::ignore_held(std::vector<IndexPair>& near, std::vector<double>& reach) const {
  const auto is_held = [&](std::int32_t i) {
    return materials_.is_held(particles_.material[static_cast<std::size_t>(i)]);
  };
  std::erase_if(near, [&](const IndexPair& pair) { return is_held(pair[0]) && is_held(pair[1]); });
  for (std::size_t i = 0; i < particles_.owned; ++i) {
    if (materials_.is_held(particles_.material[i])) reach[i] = -std::numeric_limits<double>::infinity();
  }
}

/// A new decomposition when the busiest rank has more than its share, measured in counted particles and pairs.
void Simulation::balance() {
  if (comm_.size() == 1) return;
  load_.compare(comm_);
  const std::vector<std::int64_t> cost = cost_of_owned(pairs_, particles_);
  std::vector<Vec3> positions;
  std::vector<std::int64_t> alive_cost;
  std::int64_t here = 0;
  for (std::size_t i = 0; i < particles_.owned; ++i) {
    if (is_parked(particles_.record[i])) continue;
    positions.push_back(particles_.record[i].position);
    alive_cost.push_back(cost[i]);
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

void Simulation::choose_horizons() {
  ListHorizon::Counts counts = ListHorizon::count(particles_, watch_.outer().share, time_step_.step, outer_listed_);
  comm_.sum_elements(std::span(counts.begin(), counts.end()));
  list_horizon_.choose(counts);
  watch_.set_outer_horizon(static_cast<double>(list_horizon_.steps()) * time_step_.step);
}

/// The criteria of the time step with the true greatest speed, with one warning in all.
void Simulation::check_time_step() {
  const std::int64_t step = counters_.rebuilds == 0 ? steps_ : steps_ + 1;
  const std::optional<std::size_t> fastest = fastest_particle(particles_);
  checked_speed_ = std::max(time_step_.speed, fastest ? norm(particles_.record[*fastest].velocity) : 0.0);
  const std::optional<std::string> warning =
      repose::check_time_step(comm_, guard_view(step), time_step_, fastest, !warned_of_time_step_);
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
