#pragma once

#include <span>

/// Heat capacity of a granular medium by the rule of mixtures: thesis Appendix A.
namespace repose::thermal {

/// A part of a mixture.
struct Constituent {
  double mass = 0.0;           ///< kg, or kg per m3 of the mixture
  double specific_heat = 0.0;  ///< J/(kg K)
};

/// Specific heat of a mixture in J/(kg K): the mean of its constituents by mass (A.1, corrected, and A.2).
double mixture_specific_heat(std::span<const Constituent> constituents);

/// Grains with a gas between them.
struct GranularMedium {
  double bulk_density = 0.0;       ///< kg/m3, grains per volume of the bed
  double particle_density = 0.0;   ///< kg/m3
  double specific_heat = 0.0;      ///< of the grains, J/(kg K)
  double gas_density = 0.0;        ///< kg/m3
  double gas_specific_heat = 0.0;  ///< J/(kg K)
};

/// Its heat capacity with and without the gas.
struct HeatCapacity {
  double specific_heat = 0.0;             ///< J/(kg K), with the gas (A.3)
  double volumetric = 0.0;                ///< J/(m3 K), with the gas
  double volumetric_without_gas = 0.0;    ///< J/(m3 K) (A.5)
  double gas_mass_share = 0.0;            ///< w of the gas (A.2)
  double specific_heat_difference = 0.0;  ///< of (A.3) from the grains' own (A.4), relative
  double volumetric_difference = 0.0;     ///< what the gas adds, relative
};
HeatCapacity heat_capacity_of(const GranularMedium& medium);

}  // namespace repose::thermal
