#include "run/run_plan.h"

#include <algorithm>
#include <optional>

#include "simulation/phases.h"
#include "simulation/setup.h"

namespace repose {

RunPlan::RunPlan(const Deck& deck, const ReadFile& read_file)
    : materials(deck),
      walls(make_walls(deck, materials, read_file)),
      insertion(insert_particles_of(deck, walls, read_file)) {
  const SmallestRadii radii = smallest_radii(insertion, materials.size());
  dt = choose_time_step(deck, materials, radii, expected_speed(deck, insertion.now, insertion.pours));
  check_wall_speeds(deck, walls, materials, radii, dt.step);
  const double growth = greatest_growth(deck, dt.step);
  std::optional<HeatTransfer> heat;
  if (deck.heat.enabled) heat.emplace(deck, materials, insertion, growth * growth * growth);
  const double smallest = *std::min_element(radii.of_material.begin(), radii.of_material.end());
  reach_of(deck, walls, materials, smallest, insertion.largest_radius(), growth, heat);
}

double most_steps(const Deck& deck, const TimeStep& dt) {
  double steps = 0.0;
  for (const PhaseDeck& phase : deck.phases) steps += static_cast<double>(longest_steps(phase, dt.step));
  return steps;
}

}  // namespace repose
