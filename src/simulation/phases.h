#pragma once

#include <optional>
#include <string>

#include "deck/deck.h"
#include "simulation/simulation.h"

namespace repose {

/// The longest a phase can take, in steps.
std::int64_t longest_steps(const PhaseDeck& phase, double timestep);

/// One phase of a run: changes the walls at its start and says when it is over.
class Phase {
 public:
  /// Collective. Adds and removes the phase's walls, starts its motions and sets temperatures.
  Phase(const PhaseDeck& deck, Simulation& simulation);
  /// Collective. Goes on with a phase that began at `first_step`.
  Phase(const PhaseDeck& deck, Simulation& simulation, std::int64_t first_step);

  /// Collective. Empty while the phase goes on; else the condition that ended it: "kinetic_energy", "time", "steps",
  /// "tilt_onset", "servo", "wall_force", "wall_torque" or "max_time". The energy, servos and forces are looked at
  /// every `check_every` steps, the energy not while particles are poured; the caller knows whether a measurement has
  /// `seen` what the phase waits for.
  std::optional<std::string> ended_by(const Simulation& simulation, std::int64_t check_every, bool seen = false) const;

  std::int64_t first_step() const { return first_step_; }
  std::int64_t steps_done(const Simulation& simulation) const { return simulation.steps() - first_step_; }
  std::int64_t steps_left(const Simulation& simulation) const { return longest_ - steps_done(simulation); }
  const PhaseDeck& deck() const { return deck_; }

 private:
  const PhaseDeck& deck_;
  std::int64_t first_step_;
  std::int64_t least_;    ///< steps before any condition counts
  std::int64_t longest_;  ///< steps after which the phase ends anyway
};

}  // namespace repose
