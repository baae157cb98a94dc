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
  agree_after_root(simulation.comm(), [&] { series_ = std::make_unique<TimeSeries>(path, columns, existing); });
}

void WallLoadSeries::write(const Simulation& simulation) {
  const std::vector<WallLoad> loads =
      measure_wall_loads(simulation.comm(), simulation.vector_level(), simulation.walls(), simulation.materials(),
                         simulation.particles(), simulation.wall_contacts());
  std::vector<TimeSeries::Value> row = {simulation.steps(), simulation.time()};
  for (const WallLoad& load : loads) {
    for (const Vec3& v : {load.force, load.torque}) row.insert(row.end(), {v.x, v.y, v.z});
  }
  agree_after_root(simulation.comm(), [&] { series_->append(row); });
}

}  // namespace repose
