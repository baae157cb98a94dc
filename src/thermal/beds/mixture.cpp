#include "thermal/beds/mixture.h"

#include <array>

#include "thermal/beds/bed_conductivity.h"

namespace repose::thermal {

double mixture_specific_heat(std::span<const Constituent> constituents) {
  double mass = 0.0;
  double heat = 0.0;
  for (const Constituent& c : constituents) {
    mass += c.mass;
    heat += c.mass * c.specific_heat;
  }
  return heat / mass;  // (A.1) with w_n inside the sum, (A.2)
}

HeatCapacity heat_capacity_of(const GranularMedium& m) {
  const double gas_mass = porosity_of(m.bulk_density, m.particle_density) * m.gas_density;
  const double mass = m.bulk_density + gas_mass;
  const std::array parts = {Constituent{m.bulk_density, m.specific_heat}, Constituent{gas_mass, m.gas_specific_heat}};
  HeatCapacity c;
  c.specific_heat = mixture_specific_heat(parts);  // (A.3)
  c.volumetric = mass * c.specific_heat;
  c.volumetric_without_gas = m.bulk_density * m.specific_heat;  // (A.5)
  c.gas_mass_share = gas_mass / mass;                           // (A.2)
  c.specific_heat_difference = c.specific_heat / m.specific_heat - 1.0;
  c.volumetric_difference = gas_mass * m.gas_specific_heat / c.volumetric_without_gas;
  return c;
}

}  // namespace repose::thermal
