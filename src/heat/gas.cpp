#include "heat/gas.h"

#include <cmath>

#include "base/math.h"
#include "heat/air.h"
#include "heat/constants.h"

namespace repose {

double accommodation_coefficient(double temperature, double constant) {
  return 1.0 / (1.0 + std::pow(10.0, 0.6 - (1000.0 / temperature + 1.0) / constant));  // (B.8)
}

Gas air_at(double temperature, double pressure) {
  return {.temperature = temperature,
          .pressure = pressure,
          .conductivity = air_conductivity(temperature),
          .specific_heat = air_specific_heat(temperature),
          .molar_mass = air_molar_mass,
          .accommodation = accommodation_coefficient(temperature, 2.8)};
}

double modified_free_path(const Gas& gas) {
  const double specific_gas_constant = gas_constant / gas.molar_mass;
  return 2.0 * (2.0 - gas.accommodation) / gas.accommodation *
         std::sqrt(2.0 * pi * specific_gas_constant * gas.temperature) * gas.conductivity /
         (gas.pressure * (2.0 * gas.specific_heat - specific_gas_constant));  // (B.7)
}

}  // namespace repose
