// How figures are shown: each in the unit that its key names.
#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include "campaign/figure_display.h"
#include "run/measurements/measurement.h"

namespace repose::test {
namespace {

TEST(FigureDisplay, IsInTheUnitsOfALaboratory) {
  const auto shown = [](const std::string& figure, double value) {
    const FigureDisplay display = display_of(figure);
    return std::pair(display.name, display.factor * value);
  };
  EXPECT_EQ(shown("discharged_mass_kg", 0.25), std::pair(std::string("discharged mass, g"), 250.0));
  EXPECT_EQ(shown("bulk_density_kg_m3", 2.0), std::pair(std::string("bulk density, kg/m3"), 2.0));
  EXPECT_EQ(shown("specific_flow_energy_J_kg", 5.5), std::pair(std::string("specific flow energy, mJ/g"), 5.5));
  EXPECT_EQ(shown("servos.lid.torque_Nm", 0.5), std::pair(std::string("servos lid torque, N m"), 0.5));
  EXPECT_EQ(shown("scattering.area_1.count", 7.0), std::pair(std::string("scattering area 1 count"), 7.0));
}

// Those that end with one of these units and no other.
TEST(FigureDisplay, KnowsTheUnitsOfAllFigures) {
  constexpr std::array units = {"kg", "m3", "s", "deg", "m", "J", "N", "Nm", "Pa", "K"};
  int with_unit = 0;
  for (const MeasurementKind& kind : measurement_kinds()) {
    for (const Figure& figure : kind.figures) {
      const std::string last = figure.key.substr(figure.key.find_last_of('_') + 1);
      const bool has_unit = std::find(units.begin(), units.end(), last) != units.end();
      EXPECT_EQ(display_of(figure.key).is_count, !has_unit) << figure.key;
      with_unit += has_unit ? 1 : 0;
    }
  }
  EXPECT_GT(with_unit, 20);
}

}  // namespace
}  // namespace repose::test
