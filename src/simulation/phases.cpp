#include "simulation/phases.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "measurement/energies.h"
#include "scene/walls/unit_vector.h"
#include "simulation/body_load.h"

namespace repose {
namespace {

/// Collective. Whether the force or the torque that the phase waits for is reached.
bool is_load_reached(const PhaseDeck& phase, const Simulation& simulation) {
  const WallLoad load = load_on(simulation, {phase.wall});
  if (phase.until == PhaseUntil::wall_force) return norm(load.force) > phase.force;
  return std::fabs(torque_about(load, phase.axis_origin, unit_vector(phase.axis_direction))) > phase.torque;
}

}  // namespace

std::int64_t longest_steps(const PhaseDeck& phase, double timestep) {
  std::int64_t longest = std::numeric_limits<std::int64_t>::max();
  if (!std::isnan(phase.max_time)) longest = steps_for(phase.max_time, timestep);
  if (phase.until == PhaseUntil::time) longest = std::min(longest, steps_for(phase.time, timestep));
  if (phase.until == PhaseUntil::steps) longest = std::min(longest, phase.steps);
  return longest;
}

Phase::Phase(const PhaseDeck& deck, Simulation& simulation) : Phase(deck, simulation, simulation.steps()) {
  for (const std::string& wall : deck.remove_walls) simulation.set_wall_present(wall, false);
  for (const std::string& wall : deck.add_walls) simulation.set_wall_present(wall, true);
  simulation.warm();
}

Phase::Phase(const PhaseDeck& deck, Simulation& simulation, std::int64_t first_step)
    : deck_(deck),
      first_step_(first_step),
      least_(steps_for(deck.min_time, simulation.time_step().step)),
      longest_(longest_steps(deck, simulation.time_step().step)) {
  simulation.begin_phase(deck.name);
}

std::optional<std::string> Phase::ended_by(const Simulation& simulation, std::int64_t check_every, bool seen) const {
  const std::int64_t done = steps_done(simulation);
  const bool is_asked = done >= least_ && simulation.steps() % check_every == 0;
  if (deck_.until == PhaseUntil::kinetic_energy && is_asked && !simulation.awaits_particles()) {
    const double mean = mean_kinetic_energy(simulation.comm(), simulation.materials(), simulation.particles());
    if (mean < deck_.kinetic_energy) return "kinetic_energy";
  }
  if (deck_.until == PhaseUntil::servo && is_asked && simulation.scene().servos_hold(simulation.time_step().step)) {
    return "servo";
  }
  const bool by_torque = deck_.until == PhaseUntil::wall_torque;
  if ((by_torque || deck_.until == PhaseUntil::wall_force) && is_asked && is_load_reached(deck_, simulation)) {
    return by_torque ? "wall_torque" : "wall_force";
  }
  if (deck_.until == PhaseUntil::tilt_onset && seen) return "tilt_onset";
  if (done < longest_) return {};
  const double dt = simulation.time_step().step;
  if (deck_.until == PhaseUntil::time && steps_for(deck_.time, dt) <= done) return "time";
  if (deck_.until == PhaseUntil::steps && deck_.steps <= done) return "steps";
  return "max_time";
}

}  // namespace repose
