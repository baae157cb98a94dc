#include "measurement/retained_slope.h"

#include <fmt/core.h>

#include "base/math.h"
#include "run/measurements/measurement.h"

namespace repose {
namespace {

/// None of a plugged vessel, whose bed has no slope.
void measure(const FinishedState& state, Figures& figures) {
  if (figures.contains("plugged") && figures["plugged"] == true) return;
  const auto slope = retained_slope(state.deck.retained_slope, state.grains);
  if (slope) figures["retained_slope_deg"] = *slope * 180.0 / pi;
}

std::string lines(const Figures& figures) {
  const auto slope = number_in(figures, "retained_slope_deg");
  return slope ? fmt::format("slope of the bed in the vessel {:.4g} degrees\n", *slope) : std::string();
}

}  // namespace

MeasurementKind retained_slope_measurement() {
  return {.section = "measurement.retained_slope",
          .is_enabled = [](const Deck& deck) { return deck.retained_slope.enabled; },
          .figures = {{.key = "retained_slope_deg", .from = Figure::From::grains}},
          .measure = measure,
          .lines = lines,
          .of = "bed that rises to the wall"};
}

}  // namespace repose
