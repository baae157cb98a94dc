#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "deck/check_deck.h"

namespace repose {
namespace {

void check_servo(const std::string& section, const ServoDeck& servo, const Deck& deck, DeckErrors& errors) {
  check_direction(section, "direction", servo.direction, errors);
  for (const Axis periodic : deck.domain.periodic) {
    if (servo.direction.*component(periodic) == 0.0) continue;
    errors.add(section + ".direction", fmt::format("leads along the periodic direction {} of the [domain]",
                                                   enumerators(Axis{})[static_cast<std::size_t>(periodic)]));
  }
  if (servo.max_way == 0.0 && servo.min_way == 0.0) {
    errors.add(section + ".max_way", "\"max_way\" and \"min_way\" are both 0: the wall could not move");
  }
  check_course(section, servo.times, servo.factors, errors);
  check_phase_names(section, servo.phases, deck, errors);
}

/// That a servo can act in a phase which waits for one.
void check_waits_for_servo(const std::string& section, const PhaseDeck& phase, const Deck& deck, DeckErrors& errors) {
  const bool any_acts = std::any_of(deck.walls.begin(), deck.walls.end(), [&](const WallDeck& wall) {
    const std::vector<std::string>& phases = wall.servo.phases;
    return wall.servo.enabled &&
           (phases.empty() || std::find(phases.begin(), phases.end(), phase.name) != phases.end());
  });
  if (!any_acts) errors.add(section + ".until", "\"until\" = servo needs a [wall.servo] that acts in this phase");
  if (!phase.mechanics) errors.add(section + ".until", "nothing moves in a phase without mechanics, no servo either");
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
    if (phase.until == PhaseUntil::wall_force) find_wall(section + ".wall", phase.wall, deck, errors);
  }
}

}  // namespace repose
