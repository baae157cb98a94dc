#include <cmath>
#include <optional>
#include <vector>

#include <fmt/core.h>

#include "base/math.h"
#include "comm/agreement.h"
#include "measurement/discharged_mass.h"
#include "run/measurements/measurement.h"
#include "run/measurements/phase_samples.h"
#include "simulation/body_load.h"

namespace repose {
namespace {

constexpr const char* series_file = "flow_energy.csv";

/// How a blade moves, and what the grains do against it. Any motion of a rigid body is a turn about an axis and a
/// translation along it.
struct BladeRates {
  double speed = 0.0;  ///< m/s, along the axis
  double spin = 0.0;   ///< rad/s, about the axis
  double power = 0.0;  ///< W, on the grains

  template <class Self, class Visitor>
  static void describe_state(Self& self, Visitor& v) {
    v("speed", self.speed);
    v("spin", self.spin);
    v("power", self.power);
  }
};

struct BladeResistance {
  double force = 0.0;   ///< N, along the axis, against the motion
  double torque = 0.0;  ///< N m, about the axis, against the motion
};

/// W, of a wall on the grains; the belt of a conveyor is left out.
double power_of(const SurfaceMotion& motion, const WallLoad& load) {
  return -(dot(load.force, motion.velocity) + dot(load.torque, motion.angular_velocity));
}

/// The axis goes through the point nearest to the origin of coordinates whose velocity is along it; a body that does
/// not turn has one along its velocity, and no torque.
BladeResistance resistance_of(const SurfaceMotion& motion, const WallLoad& load) {
  const double spin = norm(motion.angular_velocity);
  const double speed = norm(motion.velocity);
  if (spin == 0.0) return {.force = speed > 0.0 ? -dot(load.force, motion.velocity) / speed : 0.0};
  const Vec3 along = (1.0 / spin) * motion.angular_velocity;
  const Vec3 point = (1.0 / spin / spin) * cross(motion.angular_velocity, motion.velocity);
  const double sense = dot(motion.velocity, along) < 0.0 ? -1.0 : 1.0;
  return {.force = -sense * dot(load.force, along), .torque = -torque_about(load, point, along)};
}

BladeRates rates_of(const SurfaceMotion& motion) {
  const double spin = norm(motion.angular_velocity);
  if (spin == 0.0) return {.speed = norm(motion.velocity)};
  return {.speed = std::fabs(dot(motion.velocity, motion.angular_velocity)) / spin, .spin = spin};
}

/// The work of a blade on the grains during a phase, over its way (flow_energy.csv).
class FlowEnergyWatch : public Watch {
 public:
  FlowEnergyWatch(const Simulation& simulation, const SeriesFolder& folder)
      : deck_(simulation.deck().flow_energy), samples_(deck_.phase, deck_.interval, simulation.time_step().step) {
    agree_after_root(simulation.comm(), [&] {
      series_ = std::make_unique<TimeSeries>(
          folder.directory + "/" + series_file,
          std::vector<std::string>{"step", "time_s", "way_m", "angle_deg", "force_N", "torque_Nm", "flow_energy_J"},
          folder.existing);
    });
  }

  void phase_begins(const Simulation& simulation, const std::string& name) override {
    samples_.phase_begins(name, simulation.steps());
    if (samples_.goes_on()) last_step_ = simulation.steps();
  }
  bool is_due(std::int64_t step) const override { return samples_.is_due(step); }

  void sample(const Simulation& simulation) override {
    const std::vector<WallLoad> loads =
        measure_wall_loads(simulation.comm(), simulation.vector_level(), simulation.walls(), simulation.materials(),
                           simulation.particles(), simulation.wall_contacts());
    const std::vector<Wall>& walls = simulation.walls();
    SurfaceMotion motion;  // of all of them
    WallLoad load;
    double power = 0.0;
    for (std::size_t w = 0; w < walls.size(); ++w) {
      if (!is_of(walls, w, deck_.walls)) continue;
      motion = walls[w].placement.motion;
      load.force += loads[w].force;
      load.torque += loads[w].torque;
      power += power_of(motion, loads[w]);
    }
    BladeRates now = rates_of(motion);
    now.power = power;
    advance(simulation, now);
    const BladeResistance resistance = resistance_of(motion, load);
    agree_after_root(simulation.comm(), [&] {
      series_->append(std::vector<TimeSeries::Value>{simulation.steps(), simulation.time(), way_, angle_ * 180.0 / pi,
                                                     resistance.force, resistance.torque, work_});
    });
  }

  void phase_ends(const Simulation& simulation) override {
    if (!samples_.goes_on()) return;
    if (last_step_ < simulation.steps()) sample(simulation);
    mass_ = total_mass(simulation.comm(), simulation.materials(), simulation.mass_unit(), simulation.particles(), {});
  }

  void finish(const Simulation&, const ReadFile&, Figures& figures) override {
    if (!mass_) return;
    figures["flow_energy_J"] = work_;
    if (*mass_ > 0.0) figures["specific_flow_energy_J_kg"] = work_ / *mass_;
  }

  void sync() override { series_->sync(); }
  void visit_state(StateWriter& v) const override { visit(*this, v); }
  void visit_state(StateReader& v) override { visit(*this, v); }

 private:
  template <class Self, class Visitor>
  static void visit(Self& self, Visitor& v) {
    v("samples", self.samples_);
    v("last_step", self.last_step_);
    v("last", self.last_);
    v("way", self.way_);
    v("angle", self.angle_);
    v("work", self.work_);
    v("mass", self.mass_);
    if (self.series_) v("series", *self.series_);
  }

  /// By the trapezoidal rule, but up to the first sample, which counts for all of the time before it.
  void advance(const Simulation& simulation, const BladeRates& now) {
    const double half = 0.5 * static_cast<double>(simulation.steps() - last_step_) * simulation.time_step().step;
    const BladeRates before = last_step_ == samples_.first_step() ? now : last_;
    way_ += half * (before.speed + now.speed);
    angle_ += half * (before.spin + now.spin);
    work_ += half * (before.power + now.power);
    last_ = now;
    last_step_ = simulation.steps();
  }

  FlowEnergyDeck deck_;
  PhaseSamples samples_;
  std::unique_ptr<TimeSeries> series_;  ///< rank 0
  std::int64_t last_step_ = 0;          ///< of the last sample, or when the phase began
  BladeRates last_;
  double way_ = 0.0;            ///< m
  double angle_ = 0.0;          ///< rad
  double work_ = 0.0;           ///< J
  std::optional<double> mass_;  ///< kg in the domain when the phase ended
};

std::string lines(const Figures& figures) {
  const auto energy = number_in(figures, "flow_energy_J");
  if (!energy) return {};
  const auto specific = number_in(figures, "specific_flow_energy_J_kg");
  return fmt::format("flow energy {:.4g} mJ{}\n", 1e3 * *energy,
                     specific ? fmt::format(", {:.4g} mJ/g", *specific) : std::string());
}

}  // namespace

MeasurementKind flow_energy_measurement() {
  return {.section = "measurement.flow_energy",
          .is_enabled = [](const Deck& deck) { return deck.flow_energy.enabled; },
          .figures = {{.key = "flow_energy_J"}, {.key = "specific_flow_energy_J_kg"}},
          .files = {series_file},
          .watch = [](const Simulation& simulation, const SeriesFolder& folder) -> std::unique_ptr<Watch> {
            return std::make_unique<FlowEnergyWatch>(simulation, folder);
          },
          .lines = lines};
}

}  // namespace repose
