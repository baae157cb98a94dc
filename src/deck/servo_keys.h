#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/vec3.h"
#include "deck/key.h"

/// Walls under load.
namespace repose {

/// [wall.servo]: the wall moves along an axis so that it presses on the grains with a given force.
struct ServoDeck {
  bool enabled = false;  ///< true when the wall has the section
  Vec3 direction;        ///< in which it presses
  double force = unset;
  double max_speed = unset;
  double max_way = unset;  ///< along `direction`, from where the wall is in the deck
  double min_way = 0.0;
  std::int64_t every = 10;
  double tolerance = 0.01;
  std::vector<double> times;
  std::vector<double> factors;
  std::vector<std::string> phases;  ///< empty: all
};

template <class V>
void describe(V& v, ServoDeck& s) {
  v("direction", s.direction, Unit::none, any_value, required, "in which the wall presses, of any length");
  v("force", s.force, Unit::newton, above(0), required, "with which it is to press on the grains, along direction");
  v("max_speed", s.max_speed, Unit::speed, above(0), required, "greatest speed along direction, either way");
  v("max_way", s.max_way, Unit::metre, at_least(0), required,
    "how far it may go along direction from where it is in the deck");
  v("min_way", s.min_way, Unit::metre, Range{.max = 0.0}, optional, "how far it may go back, a negative way");
  v("every", s.every, Unit::none, from_to(1, 1000), optional, "steps between two looks at the force");
  v("tolerance", s.tolerance, Unit::none, above_to(0, 0.5), optional,
    "share of force by which a force that counts as held may be off");
  v("times", s.times, Unit::second, at_least(0), optional, "since the servo has acted, from small to large");
  v("factors", s.factors, Unit::none, at_least(0), required.when(!s.times.empty(), "times"),
    "of force at each of the times, linear between them and constant beyond");
  v("phases", s.phases, Unit::none, any_value, optional,
    "phases in which it acts; in the others the wall is held where it is; none named: all");
}

}  // namespace repose
