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

bool is_of(const std::vector<Wall>& walls, std::size_t wall, const std::vector<std::string>& names) {
  const auto is_named = [&](std::size_t w) {
    return std::find(names.begin(), names.end(), walls[w].name) != names.end();
  };
  return is_named(wall) || (walls[wall].moves_with && is_named(*walls[wall].moves_with));
}

WallLoad load_of(const Simulation& simulation, const std::vector<std::string>& walls) {
  const std::vector<WallLoad> loads =
      measure_wall_loads(simulation.comm(), simulation.vector_level(), simulation.walls(), simulation.materials(),
                         simulation.particles(), simulation.wall_contacts());
  WallLoad all;
  for (std::size_t w = 0; w < loads.size(); ++w) {
    if (!is_of(simulation.walls(), w, walls)) continue;
    all.force += loads[w].force;
    all.torque += loads[w].torque;
  }
  return all;
}

}  // namespace repose
