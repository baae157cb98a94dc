#include "measurement/surface_angle.h"

#include <algorithm>
#include <cmath>

#include "base/math.h"
#include "comm/agreement.h"
#include "integration/time_step.h"
#include "run/measurements/measurement.h"

namespace repose {
namespace {

constexpr const char* series_file = "surface_angle.csv";

/// The slope of the bed in a drum over time (surface_angle.csv), and its mean.
class SurfaceAngleWatch : public Watch {
 public:
  SurfaceAngleWatch(const Simulation& simulation, const SeriesFolder& folder)
      : first_(steps_for(simulation.deck().surface_angle.from, simulation.time_step().step)),
        every_(std::max<std::int64_t>(
            1, steps_for(simulation.deck().surface_angle.interval, simulation.time_step().step))) {
    agree_after_root(simulation.comm(), [&] {
      series_ = std::make_unique<TimeSeries>(folder.directory + "/" + series_file,
                                             std::vector<std::string>{"step", "time_s", "surface_angle_deg"},
                                             folder.existing);
    });
  }

  bool is_due(std::int64_t step) const override { return step >= first_ && (step - first_) % every_ == 0; }

  void sample(const Simulation& simulation) override {
    const std::vector<Sphere> grains = gather_grains(simulation).spheres;
    agree_after_root(simulation.comm(), [&] {
      const auto angle = surface_angle(simulation.deck().surface_angle, simulation.scene().gravity(), grains);
      if (!angle) return;
      degrees_.push_back(*angle * 180.0 / pi);
      series_->append(std::vector<TimeSeries::Value>{simulation.steps(), simulation.time(), degrees_.back()});
    });
  }

  void finish(const Simulation&, const ReadFile&, Figures& figures) override {
    figures["surface_angle_samples"] = degrees_.size();
    if (degrees_.empty()) return;
    const auto n = static_cast<double>(degrees_.size());
    double mean = 0.0;
    for (const double a : degrees_) mean += a / n;
    double variance = 0.0;
    for (const double a : degrees_) variance += (a - mean) * (a - mean) / std::max(n - 1.0, 1.0);
    figures["surface_angle_deg"] = mean;
    figures["surface_angle_deviation_deg"] = std::sqrt(variance);
  }

  void sync() override { series_->sync(); }
  void visit_state(StateWriter& v) const override { visit(*this, v); }
  void visit_state(StateReader& v) override { visit(*this, v); }

 private:
  template <class Self, class Visitor>
  static void visit(Self& self, Visitor& v) {
    v("degrees", self.degrees_);
    if (self.series_) v("series", *self.series_);
  }

  std::int64_t first_;                  ///< step
  std::int64_t every_;                  ///< steps
  std::unique_ptr<TimeSeries> series_;  ///< rank 0
  std::vector<double> degrees_;         ///< rank 0
};

}  // namespace

MeasurementKind surface_angle_measurement() {
  return {.section = "measurement.surface_angle",
          .is_enabled = [](const Deck& deck) { return deck.surface_angle.enabled; },
          .figures = {{.key = "surface_angle_deg"},
                      {.key = "surface_angle_deviation_deg"},
                      {.key = "surface_angle_samples", .kind = Figure::Kind::other, .absent = 0}},
          .files = {series_file},
          .watch = [](const Simulation& simulation, const SeriesFolder& folder) -> std::unique_ptr<Watch> {
            return std::make_unique<SurfaceAngleWatch>(simulation, folder);
          }};
}

}  // namespace repose
