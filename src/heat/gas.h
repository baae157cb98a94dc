#pragma once

/// The gas in the pores of a bed (docs/theory-thermal.md).
namespace repose {

/// Accommodation coefficient of a gas at `temperature` in K (B.8); `constant` is 2.8 for air.
double accommodation_coefficient(double temperature, double constant);

/// A gas in the pores.
struct Gas {
  double temperature = 0.0;    ///< K
  double pressure = 0.0;       ///< Pa
  double conductivity = 0.0;   ///< W/(m K)
  double specific_heat = 0.0;  ///< at constant pressure, J/(kg K)
  double molar_mass = 0.0;     ///< kg/mol
  double accommodation = 0.0;  ///< coefficient (B.8)
};

/// Air at `temperature` in K and `pressure` in Pa.
Gas air_at(double temperature, double pressure);

/// The modified mean free path l of its molecules in m (B.7).
double modified_free_path(const Gas& gas);

}  // namespace repose
