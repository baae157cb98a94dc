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
      figures["servos"][wall.name] = {{"way_m", wall.servo->way()},
                                      {"force_N", wall.servo->force()},
                                      {"target_N", wall.servo->target(dt)},
                                      {"holds", wall.servo->holds(dt)}};
    }
  }
};

std::string lines(const Figures& figures) {
  const auto servos = figures.find("servos");
  if (servos == figures.end() || !servos->is_object()) return {};
  std::string text;
  for (const auto& [wall, servo] : servos->items()) {
    text += fmt::format("wall {} has gone {:.6g} m and presses with {:.5g} N of {:.5g} N\n", wall,
                        servo["way_m"].get<double>(), servo["force_N"].get<double>(), servo["target_N"].get<double>());
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
