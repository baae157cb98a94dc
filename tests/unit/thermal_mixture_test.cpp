// The rule of mixtures, thesis Appendix A.
#include <array>

#include <gtest/gtest.h>

#include "heat/air.h"
#include "thermal/beds/mixture.h"
#include "thermal/tools/mixture_tool.h"
#include "thermal_files.h"

namespace repose::thermal {
namespace {

TEST(Mixture, IsTheMeanByMass) {
  const std::array parts = {Constituent{1.0, 1000.0}, Constituent{3.0, 600.0}};
  EXPECT_NEAR(mixture_specific_heat(parts), 700.0, 1e-12);  // not 1600, the sum without weights
}

/// A bed that is half pores: 1 kg of grains and 0.5 m3 of a gas of 0.2 kg/m3 in each m3.
TEST(Mixture, CountsTheGas) {
  const HeatCapacity c = heat_capacity_of({.bulk_density = 1.0,
                                           .particle_density = 2.0,
                                           .specific_heat = 500.0,
                                           .gas_density = 0.2,
                                           .gas_specific_heat = 1050.0});
  EXPECT_NEAR(c.volumetric_without_gas, 500.0, 1e-12);
  EXPECT_NEAR(c.volumetric, 500.0 + 0.1 * 1050.0, 1e-12);
  EXPECT_NEAR(c.gas_mass_share, 0.1 / 1.1, 1e-15);
  EXPECT_NEAR(c.specific_heat, 605.0 / 1.1, 1e-12);
  EXPECT_NEAR(c.specific_heat_difference, 0.1, 1e-14);
  EXPECT_NEAR(c.volumetric_difference, 0.21, 1e-14);
}

/// Appendix A neglects the air: 0.41 of 1.18 kg/m3 among 2115 kg/m3, 2.3e-4 of the mass and 3.1e-4 of the heat.
TEST(MixtureTool, AirMayBeNeglectedAmongGrains) {
  const Json state = mixture_tool(example("thermal_mixture.toml")).json["states"][0];
  EXPECT_NEAR(state["air_mass_share"].get<double>(), 2.30e-4, 0.02e-4);
  EXPECT_NEAR(state["volumetric_difference"].get<double>(), 3.15e-4, 0.03e-4);
  EXPECT_NEAR(state["volumetric_without_air_J_m3K"].get<double>(), 2115.0 * 734.46, 1e-6);
  EXPECT_TRUE(state["air_is_negligible"].get<bool>());
  const Json dense = mixture_tool(example("thermal_mixture.toml", {"pressure=1 MPa"})).json["states"][0];
  EXPECT_FALSE(dense["air_is_negligible"].get<bool>());
}

/// Cv = rho_bulk Cp (A.5) backwards, with the deviation of the bulk density.
TEST(MixtureTool, ConvertsAMeasuredHeatCapacity) {
  const Json state = mixture_tool(example("thermal_mixture.toml")).json["states"][1];
  EXPECT_NEAR(state["particle_specific_heat_J_kgK"].get<double>(), 751.55, 0.01);
  EXPECT_NEAR(state["particle_specific_heat_deviation_J_kgK"].get<double>(), 751.55 * 32.0 / 2115.0, 0.01);
}

TEST(MixtureTool, RefusesWhatIsNoBed) {
  expect_deck_error([] { mixture_tool(example("thermal_mixture.toml", {"bulk_density=3592"})); },
                    "the porosity would not be positive");
  expect_deck_error([] { mixture_tool(example("thermal_mixture.toml", {"state.0.measured_volumetric=1e6"})); },
                    "[[state]] needs one of \"specific_heat\" and \"measured_volumetric\"");
}

}  // namespace
}  // namespace repose::thermal
