#include "simulation/setup.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.h"
#include "base/math.h"
#include "contact/adhesion_range.h"
#include "deck/has_pair.h"
#include "integration/velocity_verlet.h"
#include "output/snapshot_reader.h"
#include "scene/particles/sphere_mass.h"
#include "scene/walls/motion.h"
#include "scene/walls/periodic_walls.h"
#include "simulation/phases.h"

namespace repose {
namespace {

/// What lets particles reach further than their radius at the start, in words; empty: nothing.
std::string further_reach(const Reach& reach, double growth) {
  std::vector<std::string> causes;
  if (growth > 1.0) causes.emplace_back("phase.growth");
  if (reach.heat_share > 0.0) causes.emplace_back("heat.max_gap");
  if (reach.adhesion_range > 0.0) causes.emplace_back("adhesion");
  return fmt::format("{}", fmt::join(causes, ", "));
}

/// The material of a particle, present or planned; that of a held twin for one that is held.
std::size_t material_of(const Insertion& insertion, std::int64_t id) {
  const std::vector<std::int64_t>& ids = insertion.now.id;
  const auto found = std::find(ids.begin(), ids.end(), id);
  if (found != ids.end())
    return static_cast<std::size_t>(insertion.now.material[static_cast<std::size_t>(found - ids.begin())]);
  const auto pour = std::find_if(insertion.pours.begin(), insertion.pours.end(),
                                 [&](const Pour& p) { return id >= p.first_id && id < p.first_id + p.size(); });
  return static_cast<std::size_t>(pour->material);
}

/// DeckError when there is no particle whose onset could be watched, or nothing that could hold it.
void check_watched_particle(const Deck& deck, const Insertion& insertion) {
  const TiltOnsetDeck& onset = deck.tilt_onset;
  if (onset.particle >= insertion.planned) {
    throw DeckError(fmt::format("measurement.tilt_onset.particle = {}: the deck has particles 0 to {}", onset.particle,
                                insertion.planned - 1));
  }
  const std::size_t material = material_of(insertion, onset.particle);
  if (material >= deck.materials.size()) {
    throw DeckError(
        fmt::format("measurement.tilt_onset.particle = {}: it is \"fixed\" or on a [[particles.motion]], and "
                    "will never begin to move by itself",
                    onset.particle));
  }
  const std::string& own = deck.materials[material].name;
  if (has_pair(deck, own, onset.against)) return;
  throw DeckError(
      fmt::format("measurement.tilt_onset.against = \"{}\": there is no [[pair]] of it and \"{}\", the "
                  "material of particle {}",
                  onset.against, own, onset.particle));
}

/// Of all particles, present and planned.
SmallestRadii smallest_radii(const Insertion& insertion, std::size_t materials) {
  SmallestRadii radii{std::vector<double>(materials, std::numeric_limits<double>::infinity())};
  insertion.for_each([&](double radius, std::size_t material) {
    radii.of_material[material] = std::min(radii.of_material[material], radius);
  });
  return radii;
}

/// DeckError when a wall's motions can take it further in a time step of `dt` s than the smallest particle may move.
void check_wall_speeds(const Deck& deck, const std::vector<Wall>& walls, const MaterialTable& materials,
                       const SmallestRadii& radii, double dt) {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t m = 0; m < radii.of_material.size(); ++m) {
    if (!materials.is_held(static_cast<std::int32_t>(m))) smallest = std::min(smallest, radii.of_material[m]);
  }
  for (std::size_t w = 0; w < walls.size(); ++w) {
    if (!walls[w].travels) continue;
    const double way = dt * greatest_speed(deck.walls[walls[w].moves_with.value_or(w)], deck.domain);
    if (way < longest_way * smallest) continue;
    throw DeckError(fmt::format(
        "wall \"{}\": its motions and servo can take it {:.3g} m within the domain in one time step of {:.3g} s, "
        "{:.2g} of the "
        "smallest radius {:.3g} m: beyond {} it could pass particles unseen; shorten time.step to {:.1e} s or slow it "
        "down",
        walls[w].name, way, dt, way / smallest, smallest, longest_way, 0.5 * dt * longest_way * smallest / way));
  }
}

/// DeckError when grown particles would meet two walls with one another, too. Radii in m of the smallest and the
/// largest particle at the start.
Reach reach_of(const Deck& deck, const std::vector<Wall>& walls, const MaterialTable& materials, double smallest,
               double largest, double growth, const std::optional<HeatTransfer>& heat) {
  Reach reach;
  const double grown = growth * largest;
  reach.heat_share = heat ? heat->state().conductance().reach_share() : 0.0;
  reach.adhesion_range = longest_holding_distance(materials, smallest, grown);
  reach.longest_skin = longest_skin(Periodicity(deck.domain), grown * (1.0 + reach.heat_share) + reach.adhesion_range,
                                    further_reach(reach, growth));
  if (growth > 1.0) check_walls_meet(deck.domain, walls, grown);
  return reach;
}

}  // namespace

std::vector<Wall> make_walls(const Deck& deck, const MaterialTable& materials, const ReadFile& read_file) {
  std::vector<Wall> walls;
  for (const WallDeck& w : deck.walls) walls.push_back(make_wall(w, materials.index_of(w.material), read_file));
  for (std::size_t w = 0; w < walls.size(); ++w) {
    const std::string& name = deck.walls[w].moves_with;
    const auto leader = std::find_if(walls.begin(), walls.end(), [&](const Wall& wall) { return wall.name == name; });
    if (!name.empty()) join(walls, w, static_cast<std::size_t>(leader - walls.begin()));
  }
  return walls;
}

Insertion insert_particles_of(const Deck& deck, const std::vector<Wall>& walls, const ReadFile& read_file) {
  Insertion insertion = insert_particles(deck, walls, read_file, [&](const std::string& file) {
    return parse_snapshot(read_file(file), file, deck.materials);
  });
  if (deck.tilt_onset.enabled) check_watched_particle(deck, insertion);
  return insertion;
}

double planned_mass(const Insertion& insertion, const MaterialTable& materials) {
  double mass = 0.0;
  insertion.for_each(
      [&](double radius, std::size_t material) { mass += sphere_mass(radius, materials[material].density); });
  return mass;
}

double greatest_growth(const Deck& deck, double timestep) {
  constexpr double most = 10.0;
  double growth = 1.0;
  for (const PhaseDeck& phase : deck.phases) {
    if (!phase.growth.enabled) continue;
    const double times =
        std::ceil(static_cast<double>(longest_steps(phase, timestep)) / static_cast<double>(phase.growth.every));
    growth *= whole_power(phase.growth.factor, times);
    if (growth <= most) continue;
    throw DeckError(
        fmt::format("phase \"{}\": its growth can make particles {:.3g} times as large, more than {:.0f}; "
                    "shorten the phase, or take a smaller growth.factor",
                    phase.name, growth, most));
  }
  return growth;
}

SetUp set_up(const Deck& deck, const MaterialTable& materials, const std::vector<Wall>& walls,
             const ReadFile& read_file) {
  SetUp s;
  s.insertion = insert_particles_of(deck, walls, read_file);
  const SmallestRadii radii = smallest_radii(s.insertion, materials.size());
  s.smallest = *std::min_element(radii.of_material.begin(), radii.of_material.end());
  s.time_step = choose_time_step(deck, materials, radii, expected_speed(deck, s.insertion.now, s.insertion.pours));
  check_wall_speeds(deck, walls, materials, radii, s.time_step.step);
  s.growth = greatest_growth(deck, s.time_step.step);
  if (deck.heat.enabled) s.heat.emplace(deck, materials, s.insertion, s.growth * s.growth * s.growth);
  s.reach = reach_of(deck, walls, materials, s.smallest, s.insertion.largest_radius(), s.growth, s.heat);
  return s;
}

}  // namespace repose
