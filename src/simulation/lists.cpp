// What keeps the neighbour lists of a simulation valid: skins that begin anew, alone or for all, and lists made anew.
#include <algorithm>
#include <limits>
#include <stdexcept>

#include "domain/migration.h"
#include "integration/velocity_verlet.h"
#include "simulation/guards.h"
#include "simulation/simulation.h"

namespace repose {
namespace {

/// Inner lists are chosen anew for all particles once so many have begun new skins alone: by then the lists have pairs
/// that are no longer near, out of order.
std::size_t most_renewed(std::size_t owned) { return 16 + owned / 32; }

/// Outer lists are made anew for all particles once so many have begun outer skins alone: by then the lists have pairs
/// far apart, out of order, and the search for partners looks through all those one by one. Each may bring a pair to a
/// particle that was not crowded.
std::size_t most_outer_renewed(std::size_t owned) { return std::min(16 + owned / 16, crowd); }

}  // namespace

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
      scene_.walls_travel() && steps_ + 1 - outer_listed_at_ > ListHorizon::choices.front() - ListHorizon::inner;
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

/// Inner lists that hold every contact of this step, but for those of ghosts that are still on their way: theirs are
/// renewed when they are here.
void Simulation::renew_inner_lists(std::span<const std::int32_t> moved) {
  const bool too_old = scene_.walls_travel() && steps_ + 1 - inner_selected_at_ >= ListHorizon::inner;
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

}  // namespace repose
