#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/core.h>

#include "base/error.h"
#include "base/math.h"
#include "comm/agreement.h"
#include "comm/order_independent_sum.h"
#include "run/measurements/measurement.h"
#include "run/measurements/phase_samples.h"
#include "simulation/body_load.h"

namespace repose {
namespace {
constexpr const char* series_file = "compression.csv";
constexpr double fit_from = 0.02, fit_to = 0.12;  // of the stress, by which it has fallen since the unloading began

/// A bed under a lid: stress, height and porosity over time (compression.csv), the porosity when it is loaded most and
/// the modulus of the first part of its unloading.
class CompressionWatch : public Watch {
 public:
  CompressionWatch(const Simulation& simulation, const SeriesFolder& folder)
      : deck_(simulation.deck().compression),
        loading_(deck_.load_phase, deck_.interval, simulation.time_step().step),
        unloading_(deck_.unload_phase, deck_.interval, simulation.time_step().step) {
    agree_after_root(simulation.comm(), [&] {
      series_ = std::make_unique<TimeSeries>(
          folder.directory + "/" + series_file,
          std::vector<std::string>{"step", "time_s", "stress_Pa", "height_m", "porosity"}, folder.existing);
    });
  }

  void phase_begins(const Simulation& simulation, const std::string& name) override {
    loading_.phase_begins(name, simulation.steps());
    unloading_.phase_begins(name, simulation.steps());
  }
  bool is_due(std::int64_t step) const override { return loading_.is_due(step) || unloading_.is_due(step); }

  void sample(const Simulation& simulation) override {
    const auto lid = std::find_if(simulation.walls().begin(), simulation.walls().end(),
                                  [&](const Wall& wall) { return wall.name == deck_.lid; });
    const double force = -dot(lid->servo->axis().direction, load_on(simulation, {deck_.lid}).force);
    const double stress = force / deck_.area;
    const double height = deck_.height - lid->servo->way();
    if (!(height > 0.0)) {
      throw PhysicsError(
          fmt::format("step {}: wall \"{}\" has gone down by {:.4g} m and through the floor, which "
                      "[measurement.compression] has {:.4g} m below it (height); no grains held it",
                      simulation.steps(), deck_.lid, lid->servo->way(), deck_.height));
    }
    const double porosity = 1.0 - solid_volume(simulation) / (deck_.area * height);
    agree_after_root(simulation.comm(), [&] {
      if (loading_.is_due(simulation.steps())) {
        stress_ = stress;
        porosity_ = porosity;
      } else {
        unloading_stress_.push_back(stress);
        unloading_strain_.push_back(-std::log(height));
      }
      series_->append(std::vector<TimeSeries::Value>{simulation.steps(), simulation.time(), stress, height, porosity});
    });
  }

  void finish(const Simulation&, const ReadFile&, Figures& figures) override {
    if (std::isnan(stress_)) return;
    figures["compression_stress_Pa"] = stress_;
    figures["compression_porosity"] = porosity_;
    if (const auto modulus = unloading_modulus()) figures["compression_modulus_Pa"] = *modulus;
  }

  void sync() override { series_->sync(); }
  void visit_state(StateWriter& v) const override { visit(*this, v); }
  void visit_state(StateReader& v) override { visit(*this, v); }

 private:
  template <class Self, class Visitor>
  static void visit(Self& self, Visitor& v) {
    v("loading", self.loading_);
    v("unloading", self.unloading_);
    v("stress", self.stress_);
    v("porosity", self.porosity_);
    v("unloading_stress", self.unloading_stress_);
    v("unloading_strain", self.unloading_strain_);
    if (self.series_) v("series", *self.series_);
  }

  /// m3, of all grains; where they overlap they count twice.
  static double solid_volume(const Simulation& simulation) {
    const Particles& particles = simulation.particles();
    std::vector<double> cubes;
    for (std::size_t i = 0; i < particles.owned; ++i) {
      const ParticleRecord& p = particles.record[i];
      if (!is_parked(p)) cubes.push_back(p.radius * p.radius * p.radius);
    }
    return 4.0 / 3.0 * pi * order_independent_sum(simulation.comm(), cubes);
  }

  /// Slope of the stress over the logarithmic strain by least squares; none of fewer than three samples, or without a
  /// stress.
  std::optional<double> unloading_modulus() const {
    if (!(stress_ > 0.0)) return {};
    double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (std::size_t k = 0; k < unloading_stress_.size(); ++k) {
      const double fallen = 1.0 - unloading_stress_[k] / stress_;
      if (fallen < fit_from || fallen > fit_to) continue;
      const double strain = unloading_strain_[k] - unloading_strain_.front();
      n += 1.0;
      x += strain;
      y += unloading_stress_[k];
      xx += strain * strain;
      xy += strain * unloading_stress_[k];
    }
    if (n < 3.0) return {};
    return (n * xy - x * y) / (n * xx - x * x);
  }

  CompressionDeck deck_;
  PhaseSamples loading_, unloading_;
  std::unique_ptr<TimeSeries> series_;                       ///< rank 0
  double stress_ = unset;                                    ///< Pa, when it was loaded last; rank 0, as all below
  double porosity_ = unset;                                  ///< then
  std::vector<double> unloading_stress_, unloading_strain_;  ///< Pa; of the height in m, from an arbitrary zero
};

std::string lines(const Figures& figures) {
  const auto stress = number_in(figures, "compression_stress_Pa");
  const auto modulus = number_in(figures, "compression_modulus_Pa");
  if (!stress || !modulus) return {};
  return fmt::format("under {:.4g} Pa the porosity is {:.4g} and the modulus of unloading {:.4g} Pa\n", *stress,
                     *number_in(figures, "compression_porosity"), *modulus);
}

}  // namespace

MeasurementKind compression_measurement() {
  return {
      .section = "measurement.compression",
      .is_enabled = [](const Deck& deck) { return deck.compression.enabled; },
      .figures = {{.key = "compression_stress_Pa"}, {.key = "compression_porosity"}, {.key = "compression_modulus_Pa"}},
      .files = {series_file},
      .watch = [](const Simulation& simulation, const SeriesFolder& folder) -> std::unique_ptr<Watch> {
        return std::make_unique<CompressionWatch>(simulation, folder);
      },
      .lines = lines};
}

}  // namespace repose
