#include "run/measurements/phase_samples.h"

#include <algorithm>
#include <utility>

#include "simulation/phases.h"

namespace repose {

PhaseSamples::PhaseSamples(std::string phase, double interval, double dt)
    : phase_(std::move(phase)), every_(std::max<std::int64_t>(1, steps_for(interval, dt))) {}

void PhaseSamples::phase_begins(const std::string& name, std::int64_t step) {
  goes_on_ = name == phase_;
  if (goes_on_) first_step_ = step;
}

WallLoad load_of(const Simulation& simulation, const std::vector<std::string>& walls) {
  const std::vector<WallLoad> loads =
      measure_wall_loads(simulation.comm(), simulation.vector_level(), simulation.walls(), simulation.materials(),
                         simulation.particles(), simulation.wall_contacts());
  const auto is_named = [&](const Wall& wall) {
    return std::find(walls.begin(), walls.end(), wall.name) != walls.end();
  };
  WallLoad all;
  for (std::size_t w = 0; w < loads.size(); ++w) {
    const Wall& wall = simulation.walls()[w];
    if (!is_named(wall) && !(wall.moves_with && is_named(simulation.walls()[*wall.moves_with]))) continue;
    all.force += loads[w].force;
    all.torque += loads[w].torque;
  }
  return all;
}

}  // namespace repose
