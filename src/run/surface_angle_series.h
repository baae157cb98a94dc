#pragma once

#include <memory>
#include <string>
#include <vector>

#include "output/summary.h"
#include "output/time_series.h"
#include "simulation/simulation.h"

namespace repose {

/// surface_angle.csv: the slope of the bed in a drum over time, and its mean.
class SurfaceAngleSeries {
 public:
  /// Creates the file or goes on with it, on rank 0. FileError when that fails.
  SurfaceAngleSeries(const Simulation& simulation, const std::string& path, Existing existing);
  bool is_due(std::int64_t step) const { return step >= first_ && (step - first_) % every_ == 0; }
  /// Collective. One row.
  void sample(const Simulation& simulation);
  /// Mean and standard deviation of the samples. For rank 0.
  void summarise(Summary& summary) const;
  /// For rank 0.
  void sync() { series_->sync(); }

  template <class Self, class Visitor>
  static void describe_state(Self& self, Visitor& v) {
    v("degrees", self.degrees_);
    if (self.series_) v("series", *self.series_);
  }

 private:
  std::int64_t first_;                  ///< step
  std::int64_t every_;                  ///< steps
  std::unique_ptr<TimeSeries> series_;  ///< rank 0
  std::vector<double> degrees_;         ///< rank 0
};

}  // namespace repose
