#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "deck/check_deck.h"
#include "deck/directions.h"

namespace repose {
namespace {

std::string name_of(Axis axis) { return std::string(enumerators(Axis{})[static_cast<std::size_t>(axis)]); }

void check_way(const std::string& section, const ServoDeck& servo, const Deck& deck, DeckErrors& errors) {
  check_direction(section, "direction", servo.direction, errors);
  for (const Axis periodic : deck.domain.periodic) {
    if (servo.direction.*component(periodic) == 0.0) continue;
    errors.add(section + ".direction",
               fmt::format("leads along the periodic direction {} of the [domain]", name_of(periodic)));
  }
  if (servo.max_way == 0.0 && servo.min_way == 0.0) {
    errors.add(section + ".max_way", "\"max_way\" and \"min_way\" are both 0: the wall could not move");
  }
}

void check_servo(const std::string& section, const ServoDeck& servo, const Deck& deck, DeckErrors& errors) {
  if (servo.type == ServoType::rotation) {
    check_torque_axis(section, servo.axis_direction, deck, errors);
    if (servo.max_angle == 0.0 && servo.min_angle == 0.0) {
      errors.add(section + ".max_angle", "\"max_angle\" and \"min_angle\" are both 0: the wall could not turn");
    }
  } else {
    check_way(section, servo, deck, errors);
  }
  check_course(section, servo.times, servo.factors, errors);
  if (!servo.factors.empty() && *std::max_element(servo.factors.begin(), servo.factors.end()) == 0.0) {
    errors.add(section + ".factors", "\"factors\" are all 0: the wall would never press; remove the [wall.servo]");
  }
  check_acting_phases(section, "the servo", servo.phases, deck, errors);
}

/// That a wall which moves with another leaves the moving to it, and that the other does not move with a third. One
/// that never moves may have followers, too: phases and measurements take them along.
void check_follower(const std::string& section, const WallDeck& wall, const Deck& deck, DeckErrors& errors) {
  const std::string key = section + ".moves_with";
  const WallDeck* leader = find_wall(key, wall.moves_with, deck, errors);
  if (leader == &wall) {
    errors.add(key, fmt::format("wall \"{}\" cannot move with itself; name the wall that moves it", wall.name));
  } else if (leader != nullptr && !leader->moves_with.empty()) {
    errors.add(key,
               fmt::format("wall \"{}\" moves with \"{}\" itself; name that one", leader->name, leader->moves_with));
  }
  if (!wall.motions.empty()) {
    errors.add(section + ".motion",
               "a wall with \"moves_with\" has no [[wall.motion]] of its own; remove one of the two");
  }
  if (wall.servo.enabled) {
    errors.add(section + ".servo", "a wall with \"moves_with\" has no [wall.servo] of its own; remove one of the two");
  }
}

}  // namespace

void check_torque_axis(const std::string& section, const Vec3& direction, const Deck& deck, DeckErrors& errors) {
  check_direction(section, "axis_direction", direction, errors);
  for (const Axis periodic : deck.domain.periodic) {
    if (are_parallel(direction, unit_along(periodic))) continue;
    errors.add(section + ".axis_direction",
               fmt::format("\"axis_direction\" is not along the periodic direction {} of the [domain]: the images of a "
                           "grain would have other levers",
                           name_of(periodic)));
  }
}

void check_servos(const Deck& deck, DeckErrors& errors) {
  for (std::size_t i = 0; i < deck.walls.size(); ++i) {
    const WallDeck& wall = deck.walls[i];
    const std::string section = fmt::format("wall.{}", i);
    if (!wall.moves_with.empty()) check_follower(section, wall, deck, errors);
    if (wall.servo.enabled) check_servo(section + ".servo", wall.servo, deck, errors);
  }
}

}  // namespace repose
