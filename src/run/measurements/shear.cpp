#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <fmt/core.h>

#include "base/math.h"
#include "comm/agreement.h"
#include "measurement/discharged_mass.h"
#include "measurement/shear_stress.h"
#include "run/measurements/measurement.h"
#include "run/measurements/phase_samples.h"
#include "simulation/body_load.h"

namespace repose {
namespace {

constexpr const char* series_file = "shear.csv";
constexpr double peak_share = 0.1;  // of the time before the stresses are steady, over which a peak is a mean

/// Nothing for a plane that bears no load.
std::optional<double> friction_angle(const ShearStress& mean) {
  if (!(mean.normal > 0.0)) return {};
  return std::atan(std::fabs(mean.shear) / mean.normal) * 180.0 / pi;
}

/// The stresses in the plane of a shear cell over time (shear.csv), the ratio of their means when they are steady and
/// the greatest ratio of means over a tenth of the time before.
class ShearWatch : public Watch {
 public:
  ShearWatch(const Simulation& simulation, const SeriesFolder& folder)
      : deck_(simulation.deck().shear), samples_(deck_.phase, deck_.interval, simulation.time_step().step) {
    agree_after_root(simulation.comm(), [&] {
      series_ = std::make_unique<TimeSeries>(
          folder.directory + "/" + series_file,
          std::vector<std::string>{"step", "time_s", "shear_time_s", "shear_stress_Pa", "normal_stress_Pa"},
          folder.existing);
    });
  }

  void phase_begins(const Simulation& simulation, const std::string& name) override {
    samples_.phase_begins(name, simulation.steps());
  }
  bool is_due(std::int64_t step) const override { return samples_.is_due(step); }

  void sample(const Simulation& simulation) override {
    const Vec3 gravity = simulation.scene().gravity();
    const double below = discharged_mass(simulation.comm(), deck_.plane_height, simulation.materials(),
                                         simulation.mass_unit(), simulation.particles(), {});
    const double all =
        total_mass(simulation.comm(), simulation.materials(), simulation.mass_unit(), simulation.particles(), {});
    const ShearStress stress =
        shear_stress(deck_, load_on(simulation, deck_.walls), below * gravity, (all - below) * gravity);
    agree_after_root(simulation.comm(), [&] {
      const double time = static_cast<double>(simulation.steps() - samples_.first_step()) * simulation.time_step().step;
      time_.push_back(time);
      shear_.push_back(stress.shear);
      normal_.push_back(stress.normal);
      series_->append(
          std::vector<TimeSeries::Value>{simulation.steps(), simulation.time(), time, stress.shear, stress.normal});
    });
  }

  void finish(const Simulation&, const ReadFile&, Figures& figures) override {
    const auto steady =
        static_cast<std::size_t>(std::lower_bound(time_.begin(), time_.end(), deck_.from) - time_.begin());
    if (steady == time_.size()) return;
    const ShearStress mean = mean_of(steady, time_.size());
    figures["shear_stress_Pa"] = std::fabs(mean.shear);
    figures["normal_stress_Pa"] = mean.normal;
    const std::optional<double> angle = friction_angle(mean);
    if (!angle) return;
    figures["internal_friction_deg"] = *angle;
    const double apart = time_.front();  // the first sample is an interval after the beginning of the phase
    const auto width = static_cast<std::size_t>(std::max(1.0, std::rint(peak_share * deck_.from / apart)));
    double peak = *angle;
    for (std::size_t first = 0; first + width <= time_.size(); ++first) {
      peak = std::max(peak, friction_angle(mean_of(first, first + width)).value_or(0.0));
    }
    figures["internal_friction_peak_deg"] = peak;
  }

  void sync() override { series_->sync(); }
  void visit_state(StateWriter& v) const override { visit(*this, v); }
  void visit_state(StateReader& v) override { visit(*this, v); }

 private:
  template <class Self, class Visitor>
  static void visit(Self& self, Visitor& v) {
    v("samples", self.samples_);
    v("time", self.time_);
    v("shear", self.shear_);
    v("normal", self.normal_);
    if (self.series_) v("series", *self.series_);
  }

  ShearStress mean_of(std::size_t first, std::size_t end) const {
    ShearStress mean;
    for (std::size_t k = first; k < end; ++k) {
      mean.shear += shear_[k] / static_cast<double>(end - first);
      mean.normal += normal_[k] / static_cast<double>(end - first);
    }
    return mean;
  }

  ShearDeck deck_;
  PhaseSamples samples_;
  std::unique_ptr<TimeSeries> series_;         ///< rank 0
  std::vector<double> time_, shear_, normal_;  ///< rank 0: s since the phase began, Pa
};

std::string lines(const Figures& figures) {
  const auto angle = number_in(figures, "internal_friction_deg");
  if (!angle) return {};
  return fmt::format("internal friction {:.4g} degrees, {:.4g} at the peak, under {:.4g} Pa\n", *angle,
                     *number_in(figures, "internal_friction_peak_deg"), *number_in(figures, "normal_stress_Pa"));
}

}  // namespace

MeasurementKind shear_measurement() {
  return {.section = "measurement.shear",
          .is_enabled = [](const Deck& deck) { return deck.shear.enabled; },
          .figures = {{.key = "internal_friction_deg"},
                      {.key = "internal_friction_peak_deg"},
                      {.key = "shear_stress_Pa"},
                      {.key = "normal_stress_Pa"}},
          .files = {series_file},
          .watch = [](const Simulation& simulation, const SeriesFolder& folder) -> std::unique_ptr<Watch> {
            return std::make_unique<ShearWatch>(simulation, folder);
          },
          .lines = lines};
}

}  // namespace repose
