// Air against the figures that its sources print.
#include <gtest/gtest.h>

#include "heat/air.h"

namespace repose::thermal {
namespace {

/// Lemmon and Jacobsen 2004, Table V, air at zero density: 100 K and 300 K, to the digits printed.
TEST(Air, IsThatOfLemmonAndJacobsen) {
  EXPECT_NEAR(air_viscosity(100.0), 7.09559e-6, 1e-11);
  EXPECT_NEAR(air_viscosity(300.0), 18.5230e-6, 1e-10);
  EXPECT_NEAR(air_conductivity(100.0), 9.35902e-3, 1e-8);
  EXPECT_NEAR(air_conductivity(300.0), 26.3529e-3, 1e-7);
}

/// Tables of dry air (Incropera and DeWitt, A.4), whose last digit is 1 J/(kg K), with the pressure's share of 2.
TEST(Air, HasTheSpecificHeatOfTables) {
  EXPECT_NEAR(air_specific_heat(300.0), 1005.0, 3.0);
  EXPECT_NEAR(air_specific_heat(600.0), 1051.0, 3.0);
  EXPECT_NEAR(air_specific_heat(1000.0 - 1e-9), 1141.0, 3.0);
  EXPECT_NEAR(air_specific_heat(1000.0), air_specific_heat(1000.0 - 1e-9), 0.05);  // two polynomials meet
}

/// 1 mol at 273.15 K and 101325 Pa takes 22.414 litres.
TEST(Air, IsAnIdealGas) { EXPECT_NEAR(air_density(273.15, 101325.0), 28.9586e-3 / 22.41396954e-3, 1e-6); }

}  // namespace
}  // namespace repose::thermal
