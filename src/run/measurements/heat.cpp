#include <fmt/core.h>

#include "files/json_text.h"
#include "heat/heat_figures.h"
#include "run/measurements/measurement.h"

namespace repose {
namespace {

/// The heat of the grains at the end of a run.
class HeatWatch : public Watch {
 public:
  void finish(const Simulation& simulation, const ReadFile&, Figures& figures) override {
    const HeatFigures heat =
        measure_heat(simulation.comm(), simulation.materials(), *simulation.heat(), simulation.particles());
    Figures walls = Figures::object();
    for (std::size_t w = 0; w < heat.walls.size(); ++w) {
      const Wall& wall = simulation.walls()[w];
      if (simulation.deck().walls[w].heat.enabled) walls[wall.name] = heat.walls[w];
    }
    figures["heat"] = {{"stored_J", heat.stored},
                       {"mean_temperature_K", json_number(heat.mean)},
                       {"lowest_temperature_K", json_number(heat.lowest)},
                       {"highest_temperature_K", json_number(heat.highest)},
                       {"walls_J", walls}};
  }
};

std::string lines(const Figures& figures) {
  const auto heat = figures.find("heat");
  if (heat == figures.end() || !heat->is_object()) return {};
  if ((*heat)["mean_temperature_K"].is_null()) return "heat none: no grains are left\n";
  const auto number = [&](const char* key) { return (*heat)[key].get<double>(); };
  return fmt::format("heat {:.5g} J, mean temperature {:.5g} K ({:.5g} to {:.5g} K)\n", number("stored_J"),
                     number("mean_temperature_K"), number("lowest_temperature_K"), number("highest_temperature_K"));
}

}  // namespace

MeasurementKind heat_measurement() {
  return {.section = "heat",
          .is_enabled = [](const Deck& deck) { return deck.heat.enabled; },
          .figures = {{.key = "heat", .kind = Figure::Kind::other},
                      {.key = "heat.stored_J"},
                      {.key = "heat.mean_temperature_K"},
                      {.key = "heat.lowest_temperature_K"},
                      {.key = "heat.highest_temperature_K"},
                      {.key = "heat.walls_J", .kind = Figure::Kind::other}},
          .watch = [](const Simulation&, const SeriesFolder&) -> std::unique_ptr<Watch> {
            return std::make_unique<HeatWatch>();
          },
          .lines = lines};
}

}  // namespace repose
