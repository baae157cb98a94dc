#include "thermal/beds/bed_conductivity.h"

#include <cmath>

#include "base/math.h"
#include "heat/constants.h"

namespace repose::thermal {
namespace {

/// (-ln(1-u) - u - u^2/2)/u^3, smooth at u = 0, for u < 1.
double third_logarithm(double u) {
  if (std::abs(u) > 0.1) return (-std::log1p(-u) - u - 0.5 * u * u) / (u * u * u);
  double sum = 0.0;
  double power = 1.0;
  for (int k = 3; k < 22; ++k) {  // the first term left out is below 1e-20
    sum += power / k;
    power *= u;
  }
  return sum;
}

}  // namespace

double deformation_parameter(const BedRatios& bed) {
  return bed.shape_factor * std::pow((1.0 - bed.porosity) / bed.porosity, 10.0 / 9.0) * bed.distribution;  // (B.4)
}

double core_conductivity(const BedRatios& bed) {
  const double b = deformation_parameter(bed);
  const double s = bed.particle + bed.radiation;
  const double u = 1.0 - b * (bed.gas + (1.0 - bed.gas) * s) / s;
  const double share = bed.particle / s;
  return bed.gas * share * share * (1.0 + 2.0 * b * (s - 1.0) * bed.gas / s * third_logarithm(u)) +
         (b + 1.0) / b * share * bed.radiation;  // (T.1)
}

double relative_bed_conductivity(const BedRatios& bed) {
  const double root = std::sqrt(1.0 - bed.porosity);
  const double pores = bed.porosity * (1.0 / (bed.porosity - 1.0 + 1.0 / bed.gas) + bed.radiation);
  const double cell = bed.flattening * bed.particle + (1.0 - bed.flattening) * core_conductivity(bed);
  return (1.0 - root) * pores + root * cell;  // (B.1), a product where the thesis prints a sum
}

double relative_radiation(double temperature, double diameter, double emissivity, double gas_conductivity) {
  const double cube = temperature * temperature * temperature;
  return 4.0 * stefan_boltzmann / (2.0 / emissivity - 1.0) * cube * diameter / gas_conductivity;  // (B.5)
}

double relative_gas_conductivity(double free_path, double diameter) {
  return 1.0 / (1.0 + free_path / diameter);
}  // (B.6)

BedRatios ratios_of(const Bed& bed, const Gas& gas) {
  return {.porosity = bed.porosity,
          .particle = bed.particle_conductivity / gas.conductivity,
          .radiation = relative_radiation(gas.temperature, bed.diameter, bed.emissivity, gas.conductivity),
          .gas = relative_gas_conductivity(modified_free_path(gas), bed.diameter),
          .flattening = bed.flattening,
          .shape_factor = bed.shape_factor,
          .distribution = bed.distribution};
}

double bed_conductivity(const Bed& bed, const Gas& gas) {
  return relative_bed_conductivity(ratios_of(bed, gas)) * gas.conductivity;
}

}  // namespace repose::thermal
