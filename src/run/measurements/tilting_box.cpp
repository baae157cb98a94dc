#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "base/math.h"
#include "comm/agreement.h"
#include "measurement/avalanche.h"
#include "measurement/surface_angle.h"
#include "run/measurements/measurement.h"

namespace repose {
namespace {

/// The slope of the bed in a box that tilts: what it had come to when the first avalanche went down, and at the end.
class TiltingBoxWatch : public Watch {
 public:
  void phase_begins(const Simulation& simulation, const std::string&) override { look(simulation); }

  void look(const Simulation& simulation) override {
    if (!simulation.scene().is_tilting() || avalanche_.seen()) return;
    if (const auto slope = slope_of(simulation)) avalanche_.add(*slope, std::fabs(simulation.scene().tilt()));
  }
  bool has_seen(PhaseUntil condition) const override {
    return condition == PhaseUntil::tilt_onset && avalanche_.seen();
  }

  void finish(const Simulation& simulation, const ReadFile&, Figures& figures) override {
    if (!avalanche_.seen()) return;
    figures["static_angle_of_repose_deg"] = avalanche_.slope() / degree;
    figures["avalanche_tilt_deg"] = avalanche_.tilt() / degree;
    if (const auto slope = slope_of(simulation)) figures["slope_after_avalanche_deg"] = *slope / degree;
  }

  void visit_state(StateWriter& v) const override { v("avalanche", avalanche_); }
  void visit_state(StateReader& v) override { v("avalanche", avalanche_); }

 private:
  /// Collective. Rad, positive where the box tilts to, on all ranks. In columns of the box, which tilt with it: what
  /// lies still does not pass from one to another.
  static std::optional<double> slope_of(const Simulation& simulation) {
    const Deck& deck = simulation.deck();
    const std::vector<Sphere> grains = gather_grains(simulation).spheres;
    double slope = unset;
    agree_after_root(simulation.comm(), [&] {
      const auto in_box = surface_angle_at_rest(deck.surface_angle, deck.gravity, grains);
      if (!in_box) return;
      const double turn = deck.tilt.angular_velocity * dot(deck.tilt.axis_direction, deck.surface_angle.axis_direction);
      slope = std::fabs(simulation.scene().tilt()) - std::copysign(*in_box, turn * *in_box);
    });
    simulation.comm().broadcast(slope);
    return std::isnan(slope) ? std::optional<double>() : slope;
  }

  Avalanche avalanche_;
};

std::string lines(const Figures& figures) {
  const auto angle = number_in(figures, "static_angle_of_repose_deg");
  if (!angle) return {};
  return fmt::format("static angle of repose {:.4g} degrees, at a tilt of {:.4g}\n", *angle,
                     *number_in(figures, "avalanche_tilt_deg"));
}

}  // namespace

MeasurementKind tilting_box_measurement() {
  return {.section = "tilt",
          .is_enabled = [](const Deck& deck) { return deck.tilt.enabled && deck.surface_angle.enabled; },
          .figures = {{.key = "static_angle_of_repose_deg"},
                      {.key = "avalanche_tilt_deg"},
                      {.key = "slope_after_avalanche_deg"}},
          .watch = [](const Simulation&, const SeriesFolder&) -> std::unique_ptr<Watch> {
            return std::make_unique<TiltingBoxWatch>();
          },
          .lines = lines};
}

}  // namespace repose
