#include "simulation/body_load.h"

#include <algorithm>

namespace repose {

bool is_of(const std::vector<Wall>& walls, std::size_t wall, const std::vector<std::string>& names) {
  const auto is_named = [&](std::size_t w) {
    return std::find(names.begin(), names.end(), walls[w].name) != names.end();
  };
  return is_named(wall) || (walls[wall].moves_with && is_named(*walls[wall].moves_with));
}

WallLoad load_on(const Simulation& simulation, const std::vector<std::string>& names) {
  const std::vector<WallLoad> loads =
      measure_wall_loads(simulation.comm(), simulation.vector_level(), simulation.walls(), simulation.materials(),
                         simulation.particles(), simulation.wall_contacts());
  WallLoad all;
  for (std::size_t w = 0; w < loads.size(); ++w) {
    if (!is_of(simulation.walls(), w, names)) continue;
    all.force += loads[w].force;
    all.torque += loads[w].torque;
  }
  return all;
}

}  // namespace repose
