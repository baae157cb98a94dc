#pragma once

#include <memory>
#include <string>

#include "output/time_series.h"
#include "simulation/simulation.h"

namespace repose {

/// walls.csv: force and torque on each wall over time, the way or the angle of its servo, and the heat that it has
/// given.
class WallLoadSeries {
 public:
  /// Creates the file or goes on with it, on rank 0. FileError when that fails.
  WallLoadSeries(const Simulation& simulation, const std::string& path, Existing existing);
  /// Collective. One row.
  void write(const Simulation& simulation);
  /// For rank 0.
  void sync() { series_->sync(); }

  template <class Self, class Visitor>
  static void describe_state(Self& self, Visitor& v) {
    if (self.series_) v("series", *self.series_);
  }

 private:
  void add_heat(const Simulation& simulation, std::vector<TimeSeries::Value>& row) const;

  std::unique_ptr<TimeSeries> series_;  ///< rank 0
};

}  // namespace repose
