#pragma once

#include <string>

namespace repose {

/// SI values of a script's units.
struct ScriptUnits {
  double length = 1.0;  ///< m
  double mass = 1.0;    ///< kg
  double time = 1.0;    ///< s

  double speed() const { return length / time; }
  double acceleration() const { return length / (time * time); }
  double density() const { return mass / (length * length * length); }
  double pressure() const { return mass / (length * time * time); }
  double power() const { return mass * length * length / (time * time * time); }
  double conductivity() const { return power() / length; }                  ///< per kelvin
  double specific_heat() const { return length * length / (time * time); }  ///< per kelvin
  double stiffness() const { return mass / (time * time); }                 ///< N/m
};

inline constexpr ScriptUnits si_units{};
inline constexpr ScriptUnits cgs_units{0.01, 0.001, 1.0};

}  // namespace repose
