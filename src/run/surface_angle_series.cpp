#include "run/surface_angle_series.h"

#include <algorithm>
#include <cmath>

#include "base/math.h"
#include "comm/agreement.h"
#include "measurement/surface_angle.h"
#include "run/phases.h"
#include "run/pile_measurement.h"

namespace repose {

SurfaceAngleSeries::SurfaceAngleSeries(const Simulation& simulation, const std::string& path, Existing existing)
    : first_(steps_for(simulation.deck().surface_angle.from, simulation.time_step().step)),
      every_(
          std::max<std::int64_t>(1, steps_for(simulation.deck().surface_angle.interval, simulation.time_step().step))) {
  agree_after_root(simulation.comm(), [&] {
    series_ =
        std::make_unique<TimeSeries>(path, std::vector<std::string>{"step", "time_s", "surface_angle_deg"}, existing);
  });
}

void SurfaceAngleSeries::sample(const Simulation& simulation) {
  const std::vector<Sphere> grains = gather_grains(simulation);
  agree_after_root(simulation.comm(), [&] {
    const auto angle = surface_angle(simulation.deck().surface_angle, simulation.scene().gravity(), grains);
    if (!angle) return;
    degrees_.push_back(*angle * 180.0 / pi);
    series_->append(std::vector<TimeSeries::Value>{simulation.steps(), simulation.time(), degrees_.back()});
  });
}

void SurfaceAngleSeries::summarise(Summary& summary) const {
  summary.surface_angle_samples = static_cast<std::int64_t>(degrees_.size());
  if (degrees_.empty()) return;
  const auto n = static_cast<double>(degrees_.size());
  double mean = 0.0;
  for (const double a : degrees_) mean += a / n;
  double variance = 0.0;
  for (const double a : degrees_) variance += (a - mean) * (a - mean) / std::max(n - 1.0, 1.0);
  summary.surface_angle_deg = mean;
  summary.surface_angle_deviation_deg = std::sqrt(variance);
}

}  // namespace repose
