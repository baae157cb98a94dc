#include <algorithm>

#include <fmt/core.h>

#include "run/measurements/measurement.h"

namespace repose {
namespace {

/// Where the walls under load have got to at the end of a run.
class ServoWatch : public Watch {
 public:
  void finish(const Simulation& simulation, const ReadFile&, Figures& figures) override {
    figures["servos"] = Figures::object();
    const double dt = simulation.time_step().step;
    for (const Wall& wall : simulation.walls()) {
      if (!wall.servo) continue;
      const Servo& servo = *wall.servo;
      Figures& figure = figures["servos"][wall.name];
      if (servo.turns()) {
        figure = {{"angle_deg", servo.angle_deg()}, {"torque_Nm", servo.force()}, {"target_Nm", servo.target(dt)}};
      } else {
        figure = {{"way_m", servo.way()}, {"force_N", servo.force()}, {"target_N", servo.target(dt)}};
      }
      figure["holds"] = servo.holds(dt);
    }
  }
};

std::string lines(const Figures& figures) {
  const auto servos = figures.find("servos");
  if (servos == figures.end() || !servos->is_object()) return {};
  std::string text;
  for (const auto& item : servos->items()) {  // clang 14 captures no part of a binding
    const Figures& servo = item.value();
    const auto number = [&servo](const char* key) { return servo[key].get<double>(); };
    text += servo.contains("way_m")
                ? fmt::format("wall {} has gone {:.6g} m and presses with {:.5g} N of {:.5g} N\n", item.key(),
                              number("way_m"), number("force_N"), number("target_N"))
                : fmt::format("wall {} has turned by {:.6g} degrees and presses with {:.5g} N m of {:.5g} N m\n",
                              item.key(), number("angle_deg"), number("torque_Nm"), number("target_Nm"));
  }
  return text;
}

}  // namespace

MeasurementKind servo_measurement() {
  return {.section = "wall.servo",
          .is_enabled =
              [](const Deck& deck) {
                return std::any_of(deck.walls.begin(), deck.walls.end(),
                                   [](const WallDeck& wall) { return wall.servo.enabled; });
              },
          .figures = {{.key = "servos", .kind = Figure::Kind::other}},
          .watch = [](const Simulation&, const SeriesFolder&) -> std::unique_ptr<Watch> {
            return std::make_unique<ServoWatch>();
          },
          .lines = lines};
}

}  // namespace repose
