#pragma once

#include <memory>
#include <string>

#include "output/time_series.h"
#include "simulation.h"

namespace repose {

/// walls.csv: force and torque on each wall over time.
class WallLoadSeries {
 public:
  /// Creates the file, on rank 0. FileError when that fails.
  WallLoadSeries(const Simulation& simulation, const std::string& path);
  /// Collective. One row.
  void write(const Simulation& simulation);

 private:
  std::unique_ptr<TimeSeries> series_;  ///< rank 0
};

}  // namespace repose
