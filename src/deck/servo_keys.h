#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/vec3.h"
#include "deck/key.h"

/// Walls under load.
namespace repose {

enum class ServoType { translation, rotation };
constexpr auto enumerators(ServoType) { return std::array<std::string_view, 2>{"translation", "rotation"}; }

/// [wall.servo]: the wall moves along an axis so that it presses on the grains with a given force, or turns about one
/// against a given torque.
struct ServoDeck {
  bool enabled = false;  ///< true when the wall has the section
  ServoType type = ServoType::translation;
  Vec3 direction;                       ///< translation: in which it presses
  double force = unset;                 ///< translation
  double max_speed = unset;             ///< translation
  double max_way = unset;               ///< translation: along `direction`, from where the wall is in the deck
  double min_way = 0.0;                 ///< translation
  Vec3 axis_origin;                     ///< rotation
  Vec3 axis_direction{0.0, 0.0, 1.0};   ///< rotation: about which it turns by the right-hand rule
  double torque = unset;                ///< rotation
  double max_angular_velocity = unset;  ///< rotation
  double max_angle = unset;             ///< rotation: degrees, from where the wall is in the deck
  double min_angle = 0.0;               ///< rotation: degrees
  std::int64_t every = 10;
  double tolerance = 0.01;
  std::vector<double> times;
  std::vector<double> factors;
  std::vector<std::string> phases;  ///< empty: all
};

template <class V>
void describe(V& v, ServoDeck& s) {
  v("type", s.type, Unit::none, any_value, optional, "translation: it presses; rotation: it turns");
  const bool turns = s.type == ServoType::rotation;
  const Presence needed_along = required.when(!turns, "type = translation");
  const Presence needed_about = required.when(turns, "type = rotation");
  v("direction", s.direction, Unit::none, any_value, needed_along, "in which the wall presses, of any length");
  v("force", s.force, Unit::newton, above(0), needed_along, "with which it is to press on the grains, along direction");
  v("max_speed", s.max_speed, Unit::speed, above(0), needed_along, "greatest speed along direction, either way");
  v("max_way", s.max_way, Unit::metre, at_least(0), needed_along,
    "how far it may go along direction from where it is in the deck");
  v("min_way", s.min_way, Unit::metre, Range{.max = 0.0}, optional.when(!turns, "type = translation"),
    "how far it may go back, a negative way");
  v("axis_origin", s.axis_origin, Unit::metre, any_value, optional.when(turns, "type = rotation"), "point of the axis");
  v("axis_direction", s.axis_direction, Unit::none, any_value, optional.when(turns, "type = rotation"),
    "direction of the axis, of any length; the wall turns by the right-hand rule");
  v("torque", s.torque, Unit::newton_metre, above(0), needed_about,
    "with which it is to turn against the grains, about the axis");
  v("max_angular_velocity", s.max_angular_velocity, Unit::angular_speed, above(0), needed_about,
    "greatest angular velocity, either way");
  v("max_angle", s.max_angle, Unit::none, at_least(0), needed_about,
    "how far it may turn from where it is in the deck, in degrees");
  v("min_angle", s.min_angle, Unit::none, Range{.max = 0.0}, optional.when(turns, "type = rotation"),
    "how far it may turn back, a negative angle in degrees");
  v("every", s.every, Unit::none, from_to(1, 1000), optional, "steps between two looks at the force or the torque");
  v("tolerance", s.tolerance, Unit::none, above_to(0, 0.5), optional,
    "share of force or torque by which one that counts as held may be off");
  v("times", s.times, Unit::second, at_least(0), optional, "since the servo has acted, from small to large");
  v("factors", s.factors, Unit::none, at_least(0), required.when(!s.times.empty(), "times"),
    "of force or torque at each of the times, linear between them and constant beyond");
  v("phases", s.phases, Unit::none, any_value, optional,
    "phases in which it acts; in the others the wall is held where it is; none named: all");
}

}  // namespace repose
