#pragma once

/// Dry air as an ideal gas. The correlations hold from 250 K to 2000 K; below a few bar the pressure changes neither
/// conductivity nor heat capacity by more than 0.3 %.
namespace repose {

inline constexpr double air_molar_mass = 28.9586e-3;  ///< kg/mol, Lemmon and Jacobsen
inline constexpr double air_min_temperature = 250.0;  ///< K
inline constexpr double air_max_temperature = 2000.0;

/// Thermal conductivity in W/(m K) of dilute dry air at `temperature` in K, within 2 %: Lemmon and Jacobsen 2004,
/// doi:10.1023/B:IJOT.0000022327.04529.f3, equations 2, 3 and 5 at zero density.
double air_conductivity(double temperature);

/// Viscosity in Pa s of dilute dry air at `temperature` in K, within 1 %: the same, equations 2 and 3.
double air_viscosity(double temperature);

/// Specific heat at constant pressure in J/(kg K) at `temperature` in K: McBride, Zehe and Gordon 2002,
/// NASA/TP-2002-211556, "Air" with nine coefficients.
double air_specific_heat(double temperature);

/// Density in kg/m3 at `temperature` in K and `pressure` in Pa: the ideal gas.
double air_density(double temperature, double pressure);

}  // namespace repose
