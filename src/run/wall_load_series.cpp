#include "run/wall_load_series.h"

#include "comm/agreement.h"
#include "measurement/wall_loads.h"

namespace repose {

WallLoadSeries::WallLoadSeries(const Simulation& simulation, const std::string& path, Existing existing) {
  std::vector<std::string> columns = {"step", "time_s"};
  for (const Wall& wall : simulation.walls()) {
    for (const char* quantity : {"force_x_N", "force_y_N", "force_z_N", "torque_x_Nm", "torque_y_Nm", "torque_z_Nm"}) {
      columns.push_back(wall.name + "_" + quantity);
    }
  }
  for (const Wall& wall : simulation.walls()) {
    if (wall.servo) columns.push_back(wall.name + (wall.servo->turns() ? "_angle_deg" : "_way_m"));
  }
  for (const WallDeck& wall : simulation.deck().walls) {
    if (!wall.heat.enabled) continue;
    columns.insert(columns.end(), {wall.name + "_heat_J", wall.name + "_temperature_K"});
  }
  agree_after_root(simulation.comm(), [&] { series_ = std::make_unique<TimeSeries>(path, columns, existing); });
}

/// Collective. What each wall with [wall.heat] has given so far, and its temperature.
void WallLoadSeries::add_heat(const Simulation& simulation, std::vector<TimeSeries::Value>& row) const {
  const HeatTransfer* heat = simulation.heat();
  if (heat == nullptr) return;
  const HeatLedger ledger = sum_of(simulation.comm(), heat->ledger_here());
  for (std::size_t w = 0; w < ledger.walls.size(); ++w) {
    if (!simulation.deck().walls[w].heat.enabled) continue;
    row.insert(row.end(), {heat->state().unit().joules(ledger.walls[w].units()), heat->wall_temperatures()[w]});
  }
}

void WallLoadSeries::write(const Simulation& simulation) {
  const std::vector<WallLoad> loads =
      measure_wall_loads(simulation.comm(), simulation.vector_level(), simulation.walls(), simulation.materials(),
                         simulation.particles(), simulation.wall_contacts());
  std::vector<TimeSeries::Value> row = {simulation.steps(), simulation.time()};
  for (const WallLoad& load : loads) {
    for (const Vec3& v : {load.force, load.torque}) row.insert(row.end(), {v.x, v.y, v.z});
  }
  for (const Wall& wall : simulation.walls()) {
    if (wall.servo) row.emplace_back(wall.servo->turns() ? wall.servo->angle_deg() : wall.servo->way());
  }
  add_heat(simulation, row);
  agree_after_root(simulation.comm(), [&] { series_->append(row); });
}

}  // namespace repose
