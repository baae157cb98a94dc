#include "heat/air.h"

#include <cmath>

#include "heat/constants.h"

namespace repose {

double air_viscosity(double temperature) {
  constexpr double energy = 103.3;  // K, Lennard-Jones
  constexpr double size = 0.360;    // nm
  constexpr double b[] = {0.431, -0.4623, 0.08406, 0.005341, -0.00331};
  const double x = std::log(temperature / energy);
  const double collision_integral =
      std::exp(b[0] + x * (b[1] + x * (b[2] + x * (b[3] + x * b[4]))));  // equation 3 of the source
  const double molar_mass_g = 1e3 * air_molar_mass;
  return 1e-6 * 0.0266958 * std::sqrt(molar_mass_g * temperature) / (size * size * collision_integral);  // equation 2
}

double air_conductivity(double temperature) {
  constexpr double critical_temperature = 132.6312;
  const double tau = critical_temperature / temperature;
  const double viscosity = 1e6 * air_viscosity(temperature);
  return 1e-3 * (1.308 * viscosity + 1.405 * std::pow(tau, -1.1) - 1.036 * std::pow(tau, -0.3));  // equation 5
}

double air_specific_heat(double temperature) {
  constexpr double molar_mass = 28.9651159e-3;  // kg/mol, that of the source, with carbon dioxide
  constexpr double cold[] = {1.009950160e4,  -1.968275610e2,  5.009155110,    -5.761013730e-3,
                             1.066859930e-5, -7.940297970e-9, 2.185231910e-12};
  constexpr double hot[] = {2.415214430e5,  -1.257874600e3,   5.144558670,    -2.138541790e-4,
                            7.065227840e-8, -1.071483490e-11, 6.577800150e-16};
  const double(&a)[7] = temperature < 1000.0 ? cold : hot;
  const double t = temperature;
  const double ratio = (a[0] / t + a[1]) / t + a[2] + t * (a[3] + t * (a[4] + t * (a[5] + t * a[6])));
  return gas_constant / molar_mass * ratio;
}

double air_density(double temperature, double pressure) {
  return pressure * air_molar_mass / (gas_constant * temperature);
}

}  // namespace repose
