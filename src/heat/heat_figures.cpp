#include "heat/heat_figures.h"

#include <algorithm>
#include <limits>

#include <fmt/core.h>

#include "base/error.h"
#include "comm/order_independent_sum.h"
#include "scene/particles/sphere_mass.h"

namespace repose {

HeatFigures measure_heat(const Communicator& comm, const MaterialTable& materials, const HeatTransfer& heat,
                         const Particles& particles) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const HeatUnit& unit = heat.state().unit();
  HeatSum stored_here;
  double lowest = infinity, highest = -infinity;
  std::vector<double> mass, weighted;
  for (std::size_t i = 0; i < particles.owned; ++i) {
    if (is_parked(particles.record[i])) continue;
    stored_here.add(particles.heat[i]);
    const double temperature = heat.state().temperature(particles, i);
    mass.push_back(
        sphere_mass(particles.record[i].radius, materials[static_cast<std::size_t>(particles.material[i])].density));
    weighted.push_back(mass.back() * temperature);
    lowest = std::min(lowest, temperature);
    highest = std::max(highest, temperature);
  }
  const HeatSum stored = sum_of(comm, std::span<const HeatSum>(&stored_here, 1))[0];
  const HeatLedger ledger = sum_of(comm, heat.ledger_here());
  if (!(stored == ledger.inside())) {
    throw PhysicsError(
        fmt::format("the particles have {} J of heat instead of the {} J that have come and not gone: some "
                    "was lost",
                    unit.joules(stored.units()), unit.joules(ledger.inside().units())));
  }
  HeatFigures figures;
  figures.stored = unit.joules(stored.units());
  const double total_mass = order_independent_sum(comm, mass);
  const double total = order_independent_sum(comm, weighted);
  if (total_mass > 0.0) figures.mean = total / total_mass;
  lowest = comm.min(lowest);
  highest = comm.max(highest);
  if (total_mass > 0.0) {
    figures.lowest = lowest;
    figures.highest = highest;
  }
  for (const HeatSum& wall : ledger.walls) figures.walls.push_back(unit.joules(wall.units()));
  return figures;
}

}  // namespace repose
