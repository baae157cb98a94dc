#include <algorithm>

#include <fmt/core.h>

#include "deck/acts_in.h"
#include "deck/check_deck.h"
#include "deck/nearest.h"
#include "deck/present_walls.h"

namespace repose {
namespace {

void check_phase_keys(const std::string& section, const PhaseDeck& phase, DeckErrors& errors) {
  if (phase.min_time > phase.max_time) {
    errors.add(section + ".min_time",
               fmt::format("\"min_time\" = {} is beyond \"max_time\" = {}", phase.min_time, phase.max_time));
  }
  if (phase.growth.enabled && !phase.mechanics)
    errors.add(section + ".growth", "nothing grows in a phase without mechanics; remove one of the two");
}

/// That walls which a phase removes are there, and those which it adds are not.
void check_wall_changes(const std::string& section, const PhaseDeck& phase, const Deck& deck, PresentWalls& walls,
                        DeckErrors& errors) {
  for (std::size_t k = 0; k < phase.remove_walls.size(); ++k) {
    const std::string key = fmt::format("{}.remove_walls.{}", section, k);
    const std::string& name = phase.remove_walls[k];
    if (find_wall(key, name, deck, errors) == nullptr || walls.remove(name)) continue;
    errors.add(key, fmt::format("wall \"{}\" is not there when this phase begins and cannot be removed", name));
  }
  for (const std::string& name : phase.remove_walls) walls.take_along(name);
  for (std::size_t k = 0; k < phase.add_walls.size(); ++k) {
    const std::string key = fmt::format("{}.add_walls.{}", section, k);
    const std::string& name = phase.add_walls[k];
    if (find_wall(key, name, deck, errors) == nullptr || walls.add(name)) continue;
    errors.add(key,
               fmt::format("wall \"{}\" is already there when this phase begins; set present = false, or remove it "
                           "in an earlier phase",
                           name));
  }
  for (const std::string& name : phase.add_walls) walls.take_along(name);
}

/// That a servo acts in a phase which waits for one, and on a wall that is there.
void check_waits_for_servo(const std::string& key, const PhaseDeck& phase, const PresentWalls& walls, const Deck& deck,
                           DeckErrors& errors) {
  bool any_acts = false;
  for (const WallDeck& wall : deck.walls) {
    if (!wall.servo.enabled || !acts_in(wall.servo.phases, phase.name)) continue;
    if (walls.has_body(wall.name)) return;
    any_acts = true;
  }
  errors.add(key, any_acts ? "\"until\" = servo: no wall whose [wall.servo] acts in this phase is there; add it "
                             "(add_walls)"
                           : "\"until\" = servo needs a [wall.servo] that acts in this phase");
}

void check_waits_for_load(const std::string& section, const PhaseDeck& phase, const PresentWalls& walls,
                          const Deck& deck, DeckErrors& errors) {
  const std::string key = section + ".wall";
  if (find_wall(key, phase.wall, deck, errors) != nullptr && !walls.has_body(phase.wall)) {
    errors.add(key, fmt::format("wall \"{}\" is not there in this phase, so that no grain can press on it; add it "
                                "(add_walls), or name another",
                                phase.wall));
  }
  if (phase.until == PhaseUntil::wall_torque) check_torque_axis(section, phase.axis_direction, deck, errors);
}

void check_waits_for_onset(const std::string& key, const PhaseDeck& phase, const Deck& deck, DeckErrors& errors) {
  if (!deck.tilt_onset.enabled && !(deck.tilt.enabled && deck.surface_angle.enabled)) {
    errors.add(key,
               "\"until\" = tilt_onset needs [measurement.tilt_onset], or a [tilt] and [measurement.surface_angle]");
  }
  if (deck.tilt.enabled && !acts_in(deck.tilt.phases, phase.name)) {
    errors.add(key, "\"until\" = tilt_onset: the [tilt] does not act in this phase; name it in tilt.phases");
  }
}

/// That what a phase waits for can happen.
void check_condition(const std::string& section, const PhaseDeck& phase, const PresentWalls& walls, const Deck& deck,
                     DeckErrors& errors) {
  const std::string key = section + ".until";
  if (!phase.mechanics && may_never_hold(phase.until)) {
    errors.add(key, fmt::format("\"until\" = {} waits for nothing: nothing moves in a phase without mechanics; give "
                                "\"time\" or \"steps\"",
                                enumerators(PhaseUntil{})[static_cast<std::size_t>(phase.until)]));
  }
  if (phase.until == PhaseUntil::servo) check_waits_for_servo(key, phase, walls, deck, errors);
  if (phase.until == PhaseUntil::tilt_onset) check_waits_for_onset(key, phase, deck, errors);
  if (phase.until == PhaseUntil::wall_force || phase.until == PhaseUntil::wall_torque) {
    check_waits_for_load(section, phase, walls, deck, errors);
  }
}

}  // namespace

bool check_phase_names(const std::string& section, const std::vector<std::string>& named, const Deck& deck,
                       DeckErrors& errors) {
  std::vector<std::string> phases;
  for (const PhaseDeck& phase : deck.phases) phases.push_back(phase.name);
  bool are_known = true;
  for (std::size_t k = 0; k < named.size(); ++k) {
    if (std::find(phases.begin(), phases.end(), named[k]) != phases.end()) continue;
    are_known = false;
    errors.add(fmt::format("{}.phases.{}", section, k),
               fmt::format("unknown phase \"{}\"; the nearest is \"{}\"", named[k], nearest(named[k], phases)));
  }
  return are_known;
}

void check_acting_phases(const std::string& section, const char* what, const std::vector<std::string>& named,
                         const Deck& deck, DeckErrors& errors) {
  if (!check_phase_names(section, named, deck, errors)) return;
  for (std::size_t k = 0; k < named.size(); ++k) {
    const auto until_here = named.begin() + static_cast<std::ptrdiff_t>(k);
    if (std::find(named.begin(), until_here, named[k]) == until_here) continue;
    errors.add(fmt::format("{}.phases.{}", section, k), fmt::format("phase \"{}\" is named twice", named[k]));
  }
  const bool ever_acts = std::any_of(deck.phases.begin(), deck.phases.end(), [&](const PhaseDeck& phase) {
    return phase.mechanics && acts_in(named, phase.name);
  });
  if (ever_acts) return;
  errors.add(section + ".phases", fmt::format("{} acts in phases without mechanics alone, in which nothing moves; name "
                                              "another phase, or remove it",
                                              what));
}

void check_phases(const Deck& deck, DeckErrors& errors) {
  PresentWalls walls(deck);
  const std::size_t errors_before = errors.count();
  for (std::size_t i = 0; i < deck.phases.size(); ++i) {
    const PhaseDeck& phase = deck.phases[i];
    const std::string section = fmt::format("phase.{}", i);
    check_phase_keys(section, phase, errors);
    check_wall_changes(section, phase, deck, walls, errors);
    if (errors.count() > errors_before) return;  // a misspelled wall would not be there, either
    check_condition(section, phase, walls, deck, errors);
  }
}

}  // namespace repose
