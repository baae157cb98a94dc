#pragma once

#include <memory>
#include <string>
#include <vector>

#include "output/summary.h"
#include "output/time_series.h"
#include "simulation.h"

namespace repose {

/// surface_angle.csv: the slope of the bed in a drum over time, and its mean.
class SurfaceAngleSeries {
 public:
  /// Creates the file, on rank 0. FileError when that fails.
  SurfaceAngleSeries(const Simulation& simulation, const std::string& path);
  bool is_due(std::int64_t step) const { return step >= first_ && (step - first_) % every_ == 0; }
  /// Collective. One row.
  void sample(const Simulation& simulation);
  /// Mean and standard deviation of the samples. For rank 0.
  void summarise(Summary& summary) const;

 private:
  std::int64_t first_;                  ///< step
  std::int64_t every_;                  ///< steps
  std::unique_ptr<TimeSeries> series_;  ///< rank 0
  std::vector<double> degrees_;         ///< rank 0
};

}  // namespace repose
