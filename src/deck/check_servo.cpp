#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "deck/check_deck.h"
#include "deck/nearest.h"

namespace repose {
namespace {

bool is_named(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

void check_servo(const std::string& section, const ServoDeck& servo, const Deck& deck, DeckErrors& errors) {
  if (!(norm(servo.direction) > 0.0)) {
    errors.add(section + ".direction", "\"direction\" has length zero; it needs a direction");
  }
  for (const Axis periodic : deck.domain.periodic) {
    if (servo.direction.*component(periodic) == 0.0) continue;
    errors.add(section + ".direction", fmt::format("leads along the periodic direction {} of the [domain]",
                                                   enumerators(Axis{})[static_cast<std::size_t>(periodic)]));
  }
  if (servo.max_way == 0.0 && servo.min_way == 0.0) {
    errors.add(section + ".max_way", "\"max_way\" and \"min_way\" are both 0: the wall could not move");
  }
  const auto falls = [](double a, double b) { return b <= a; };
  if (std::adjacent_find(servo.times.begin(), servo.times.end(), falls) != servo.times.end()) {
    errors.add(section + ".times", "\"times\" must rise");
  }
  if (servo.factors.size() != servo.times.size()) {
    errors.add(section + ".factors",
               fmt::format("{} values for {} times; give one each", servo.factors.size(), servo.times.size()));
  }
  check_phase_names(section, servo.phases, deck, errors);
}

/// That a servo can act in a phase which waits for one.
void check_waits_for_servo(const std::string& section, const PhaseDeck& phase, const Deck& deck, DeckErrors& errors) {
  const bool any_acts = std::any_of(deck.walls.begin(), deck.walls.end(), [&](const WallDeck& wall) {
    return wall.servo.enabled && (wall.servo.phases.empty() || is_named(wall.servo.phases, phase.name));
  });
  if (!any_acts) errors.add(section + ".until", "\"until\" = servo needs a [wall.servo] that acts in this phase");
  if (!phase.mechanics) errors.add(section + ".until", "nothing moves in a phase without mechanics, no servo either");
}

void check_waits_for_wall(const std::string& section, const PhaseDeck& phase, const Deck& deck, DeckErrors& errors) {
  std::vector<std::string> walls;
  for (const WallDeck& wall : deck.walls) walls.push_back(wall.name);
  if (is_named(walls, phase.wall)) return;
  errors.add(section + ".wall", walls.empty() ? fmt::format("unknown wall \"{}\"; the deck has none", phase.wall)
                                              : fmt::format("unknown wall \"{}\"; the nearest is \"{}\"", phase.wall,
                                                            nearest(phase.wall, walls)));
}

}  // namespace

void check_servos(const Deck& deck, DeckErrors& errors) {
  for (std::size_t i = 0; i < deck.walls.size(); ++i) {
    const ServoDeck& servo = deck.walls[i].servo;
    if (servo.enabled) check_servo(fmt::format("wall.{}.servo", i), servo, deck, errors);
  }
  for (std::size_t i = 0; i < deck.phases.size(); ++i) {
    const PhaseDeck& phase = deck.phases[i];
    const std::string section = fmt::format("phase.{}", i);
    if (phase.until == PhaseUntil::servo) check_waits_for_servo(section, phase, deck, errors);
    if (phase.until == PhaseUntil::wall_force) check_waits_for_wall(section, phase, deck, errors);
  }
}

}  // namespace repose
