#pragma once

#include "deck/schema_types.h"

/// Schema of the run: what is simulated, for how long, what is written.
namespace repose {

template <class V>
void describe(V& v, RunDeck& r) {
  v("title", r.title, Unit::none, any_value, optional, "free text, copied to the results");
  v("seed", r.seed, Unit::none, at_least(0), optional, "seed of every random number");
  v("check_every", r.check_every, Unit::none, at_least(1), optional,
    "steps between looks at the energy condition of a phase and between samples of the discharge");
}

template <class V>
void describe(V& v, DomainDeck& d) {
  v("min", d.min, Unit::metre, any_value, required, "lowest corner");
  v("max", d.max, Unit::metre, any_value, required, "highest corner, beyond min in x, y and z");
  v("periodic", d.periodic, Unit::none, any_value, optional,
    "directions in which the domain repeats itself: what leaves it there comes in on the other side");
}

template <class V>
void describe(V& v, ExitDeck& e) {
  v("name", e.name, Unit::none, any_value, required, "name, used once");
  v("face", e.face, Unit::none, any_value, required, "face of the domain");
  v("min", e.min, Unit::metre, any_value, optional_else("the domain's min"),
    "lowest corner of the part; across the face it does not matter");
  v("max", e.max, Unit::metre, any_value, optional_else("the domain's max"), "highest corner of the part");
}

template <class V>
void describe(V& v, TiltDeck& t) {
  v("axis_direction", t.axis_direction, Unit::none, any_value, optional, "direction of the axis, of any length");
  v("angular_velocity", t.angular_velocity, Unit::angular_speed, any_value, required,
    "of the apparatus about the axis by the right-hand rule");
  v("phases", t.phases, Unit::none, any_value, optional, "phases in which it tilts; none named: all");
}

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

template <class V>
void describe(V& v, PhaseDeck& p) {
  v("name", p.name, Unit::none, any_value, required, "name, used once");
  v("until", p.until, Unit::none, any_value, required, "what ends the phase");
  const bool by_energy = p.until == PhaseUntil::kinetic_energy;
  v("kinetic_energy", p.kinetic_energy, Unit::joule, above(0), required.when(by_energy, "until = kinetic_energy"),
    "ends when the mean translational energy per particle is below");
  v("time", p.time, Unit::second, above(0), required.when(p.until == PhaseUntil::time, "until = time"), "duration");
  v("steps", p.steps, Unit::none, at_least(1), required.when(p.until == PhaseUntil::steps, "until = steps"),
    "number of steps");
  v("min_time", p.min_time, Unit::second, at_least(0), optional.when(by_energy, "until = kinetic_energy"),
    "the condition is not asked before");
  v("max_time", p.max_time, Unit::second, above(0),
    by_energy || p.until == PhaseUntil::tilt_onset ? required
                                                   : optional_else("none; kinetic_energy and tilt_onset need it"),
    "ends the phase whatever its condition says");
  v("remove_walls", p.remove_walls, Unit::none, any_value, optional, "walls that vanish at the start of the phase");
  v("add_walls", p.add_walls, Unit::none, any_value, optional, "walls that appear at the start of the phase");
}

template <class V>
void describe(V& v, OutputDeck& o) {
  v("snapshot_interval", o.snapshot_interval, Unit::second, at_least(0), optional,
    "time between snapshots; 0: only snapshot_times and the end");
  v("snapshot_times", o.snapshot_times, Unit::second, at_least(0), optional, "further snapshots");
  v("series_interval", o.series_interval, Unit::second, above(0), optional, "time between rows of the time series");
  v("progress_seconds", o.progress_seconds, Unit::second, above(0), optional, "wall-clock time between progress lines");
  v("checkpoint_minutes", o.checkpoint_minutes, Unit::none, at_least(0), optional,
    "wall-clock minutes between checkpoints; 0: not by time");
  v("checkpoint_steps", o.checkpoint_steps, Unit::none, at_least(0), optional,
    "steps between checkpoints; 0: not by steps");
  v("trace", o.trace, Unit::none, any_value, optional, "write every particle to a CSV file; for small cases");
  v("trace_every", o.trace_every, Unit::none, at_least(1), optional, "steps between rows of the trace");
}

template <class V>
void describe(V& v, GuardsDeck& g) {
  v("max_overlap", g.max_overlap, Unit::none, above_to(0, 0.5), optional,
    "largest overlap as a share of the smaller radius");
}

template <class V>
void describe(V& v, NeighboursDeck& n) {
  v("skin", n.skin, Unit::none, above_to(0, 10), optional,
    "outer skin at rest in particle radii, each particle's share");
  v("inner_skin", n.inner_skin, Unit::none, above_to(0, 10), optional,
    "inner skin at rest in particle radii, at most skin");
  v("max_imbalance", n.max_imbalance, Unit::none, above(1), optional,
    "cost of the busiest rank over the mean that triggers rebalancing");
}

}  // namespace repose
