#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/vec3.h"
#include "deck/key.h"

/// Phases, the tilt and the time step.
namespace repose {

enum class Integrator { velocity_verlet, synchronised_verlet };
constexpr auto enumerators(Integrator) {
  return std::array<std::string_view, 2>{"velocity_verlet", "synchronised_verlet"};
}

struct TimeDeck {
  Integrator integrator = Integrator::velocity_verlet;
  double step = unset;  ///< given time step; default: from the criteria
  double rayleigh_fraction = 0.20;
  double hertz_fraction = 0.10;
  double hooke_fraction = 0.02;
  double expected_speed = unset;  ///< default: free fall over the scene's height
};

template <class V>
void describe(V& v, TimeDeck& t) {
  v("integrator", t.integrator, Unit::none, any_value, optional,
    "synchronised_verlet: histories follow the normal of half a step ago, for sizes that differ by 3 or more");
  v("rayleigh_fraction", t.rayleigh_fraction, Unit::none, above_to(0, 1), optional,
    "largest step as a share of the Rayleigh time");
  v("hertz_fraction", t.hertz_fraction, Unit::none, above_to(0, 1), optional,
    "largest step as a share of the Hertz time");
  v("hooke_fraction", t.hooke_fraction, Unit::none, above_to(0, 1), optional,
    "largest step as a share of the collision time, which replaces both others with normal_law = hooke");
  v("expected_speed", t.expected_speed, Unit::speed, above(0), optional_else("free fall over the scene's height"),
    "impact speed of the Hertz time");
  v("step", t.step, Unit::second, above(0), optional_else("the smallest of the shares"),
    "time step; longer than the shares allow is an error");
}

/// The apparatus tilts: gravity turns about an axis the other way.
struct TiltDeck {
  bool enabled = false;  ///< true when the deck has the section
  Vec3 axis_direction{0.0, 1.0, 0.0};
  double angular_velocity = unset;
  std::vector<std::string> phases;  ///< empty: all
};

template <class V>
void describe(V& v, TiltDeck& t) {
  v("axis_direction", t.axis_direction, Unit::none, any_value, optional, "direction of the axis, of any length");
  v("angular_velocity", t.angular_velocity, Unit::angular_speed, any_value, required,
    "of the apparatus about the axis by the right-hand rule");
  v("phases", t.phases, Unit::none, any_value, optional, "phases in which it tilts; none named: all");
}

enum class PhaseUntil { kinetic_energy, time, steps, tilt_onset, servo, wall_force, wall_torque };
constexpr auto enumerators(PhaseUntil) {
  return std::array<std::string_view, 7>{"kinetic_energy", "time",       "steps",      "tilt_onset",
                                         "servo",          "wall_force", "wall_torque"};
}

/// Whether a condition may never come to hold, so that the phase needs a max_time.
constexpr bool may_never_hold(PhaseUntil until) { return until != PhaseUntil::time && until != PhaseUntil::steps; }

/// [phase.growth]: all particles that move become larger, all alike.
struct GrowthDeck {
  bool enabled = false;  ///< true when the phase has the section
  double factor = unset;
  std::int64_t every = 0;
};

template <class V>
void describe(V& v, GrowthDeck& g) {
  v("factor", g.factor, Unit::none, from_to(1, 1.1), required,
    "by which diameters grow each time, of the same density");
  v("every", g.every, Unit::none, from_to(1, 1000000), required, "steps between two times; each makes new lists");
}

/// [[phase.heat]]: heat for the particles in a box.
struct PhaseHeatDeck {
  Vec3 min;
  Vec3 max;
  double temperature = unset;
  double power = unset;
};

template <class V>
void describe(V& v, PhaseHeatDeck& h) {
  v("min", h.min, Unit::metre, any_value, required, "lowest corner of the box");
  v("max", h.max, Unit::metre, any_value, required, "highest corner of the box");
  v("temperature", h.temperature, Unit::kelvin, above_to(0, 5000), optional_else("as it is"),
    "of the particles that are in the box when the phase begins");
  v("power", h.power, Unit::watt, any_value, optional_else("none"),
    "into each particle while it is in the box during the phase; below 0 it cools");
}

struct PhaseDeck {
  std::string name;
  PhaseUntil until = PhaseUntil::time;
  double kinetic_energy = unset;       ///< kinetic_energy: mean translational energy per particle to fall below
  double time = unset;                 ///< time: duration of the phase
  std::int64_t steps = 0;              ///< steps: length of the phase
  std::string wall;                    ///< wall_force, wall_torque: on which these are looked at
  double force = unset;                ///< wall_force: magnitude to be reached
  double torque = unset;               ///< wall_torque: magnitude to be reached
  Vec3 axis_origin;                    ///< wall_torque: point of the axis of the torque
  Vec3 axis_direction{0.0, 0.0, 1.0};  ///< wall_torque
  double min_time = 0.0;
  double max_time = unset;  ///< ends the phase whatever its condition
  bool mechanics = true;    ///< false: nothing moves, heat alone goes on
  std::vector<std::string> remove_walls;
  std::vector<std::string> add_walls;
  GrowthDeck growth;
  std::vector<PhaseHeatDeck> heat;
};

template <class V>
void describe(V& v, PhaseDeck& p) {
  v("name", p.name, Unit::none, any_value, required, "name, used once");
  v("until", p.until, Unit::none, any_value, required, "what ends the phase");
  const bool by_energy = p.until == PhaseUntil::kinetic_energy;
  v("kinetic_energy", p.kinetic_energy, Unit::joule, above(0), required.when(by_energy, "until = kinetic_energy"),
    "ends when the mean translational energy per particle is below");
  v("time", p.time, Unit::second, above(0), required.when(p.until == PhaseUntil::time, "until = time"), "duration");
  v("steps", p.steps, Unit::none, from_to(1, 1e15), required.when(p.until == PhaseUntil::steps, "until = steps"),
    "number of steps");
  const bool by_force = p.until == PhaseUntil::wall_force;
  const bool by_torque = p.until == PhaseUntil::wall_torque;
  v("wall", p.wall, Unit::none, any_value, required.when(by_force || by_torque, "until = wall_force, wall_torque"),
    "name of the wall");
  v("force", p.force, Unit::newton, above(0), required.when(by_force, "until = wall_force"),
    "ends when the magnitude of the grains' force on the wall is above");
  v("torque", p.torque, Unit::newton_metre, above(0), required.when(by_torque, "until = wall_torque"),
    "ends when the magnitude of the grains' torque on the wall about the axis is above");
  v("axis_origin", p.axis_origin, Unit::metre, any_value, optional.when(by_torque, "until = wall_torque"),
    "point of the axis");
  v("axis_direction", p.axis_direction, Unit::none, any_value, optional.when(by_torque, "until = wall_torque"),
    "direction of the axis, of any length");
  v("min_time", p.min_time, Unit::second, at_least(0),
    optional.when(by_energy || by_force || by_torque || p.until == PhaseUntil::servo,
                  "until = kinetic_energy, servo, wall_force, wall_torque"),
    "the condition is not asked before");
  v("max_time", p.max_time, Unit::second, above(0),
    may_never_hold(p.until) ? required : optional_else("none; all but time and steps need it"),
    "ends the phase whatever its condition says");
  v("mechanics", p.mechanics, Unit::none, any_value, optional,
    "false: every grain stays where it is and heat alone goes on; needs [heat]");
  v("remove_walls", p.remove_walls, Unit::none, any_value, optional, "walls that vanish at the start of the phase");
  v("add_walls", p.add_walls, Unit::none, any_value, optional, "walls that appear at the start of the phase");
  v.section("growth", p.growth, optional, "particles that grow: a way to dense packings");
  v.sections("heat", p.heat, optional,
             "heat for the particles in a box, of several the last that holds one; needs [heat]");
}

}  // namespace repose
