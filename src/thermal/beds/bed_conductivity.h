#pragma once

#include "heat/gas.h"

/// The effective conductivity of a bed of grains in a gas after Zehner, Bauer and Schluender: thesis Appendix B, as
/// corrected in docs/theory-thermal.md after VDI Heat Atlas D6.3. All lambdas are ratios to the gas's conductivity.
namespace repose::thermal {

/// Porosity from the bulk density and the density of the grains, both in kg/m3 (T.0).
constexpr double porosity_of(double bulk_density, double particle_density) {
  return 1.0 - bulk_density / particle_density;
}

/// What the bed's relative conductivity depends on; dimensionless.
struct BedRatios {
  double porosity = 0.4;
  double particle = 100.0;     ///< lambda_p = k_p/k_f
  double radiation = 0.0;      ///< lambda_rad (B.5)
  double gas = 1.0;            ///< lambda_G (B.6): 1 in the continuum
  double flattening = 0.0;     ///< phi, share of the cross-section that is contact
  double shape_factor = 1.25;  ///< C_f: 1.25 spheres, 1.40 broken grains
  double distribution = 1.0;   ///< f(zeta) of the sizes: 1 for one size
};

/// The deformation parameter B (B.4).
double deformation_parameter(const BedRatios& bed);

/// Relative conductivity of the core of the unit cell, lambda_c (B.2, B.3), in the form (T.1) that has no singularity
/// at N = 0.
double core_conductivity(const BedRatios& bed);

/// k_bulk/k_f (B.1, corrected).
double relative_bed_conductivity(const BedRatios& bed);

/// lambda_rad (B.5) of grains of `diameter` in m and `emissivity` at `temperature` in K in a gas of
/// `gas_conductivity` in W/(m K).
double relative_radiation(double temperature, double diameter, double emissivity, double gas_conductivity);

/// lambda_G (B.6): Smoluchowski's effect in pores as wide as the grains' diameter in m.
double relative_gas_conductivity(double free_path, double diameter);

/// A bed in air.
struct Bed {
  double porosity = 0.0;
  double diameter = 0.0;               ///< m
  double particle_conductivity = 0.0;  ///< W/(m K)
  double emissivity = 0.0;
  double shape_factor = 1.25;
  double distribution = 1.0;
  double flattening = 0.0;
};

/// The ratios of the bed with that gas.
BedRatios ratios_of(const Bed& bed, const Gas& gas);

/// Effective conductivity of the bed in W/(m K) (B.1).
double bed_conductivity(const Bed& bed, const Gas& gas);

}  // namespace repose::thermal
