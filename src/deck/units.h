#pragma once

#include <string>
#include <string_view>

namespace repose {

/// The SI unit of a key.
enum class Unit {
  none,
  metre,
  second,
  area,
  volume,
  kilogram,
  pascal,
  density,
  speed,
  acceleration,
  joule,
  newton,
  newton_metre,
  mass_rate,
  per_second,
  hertz,
  angular_speed,
  stiffness,
  kelvin,
  watt,
  conductance,
  specific_power,
  ohm,
  conductivity,
  specific_heat,
  volumetric_heat,
  diffusivity,
  per_kelvin,
  heating_rate
};

/// The SI symbol, such as "kg/m3"; "-" for a number without a unit.
std::string_view symbol(Unit unit);

/// A number converted to SI, or what is wrong with its text (then value means nothing).
struct Quantity {
  double value = 0.0;
  std::string problem;
};

/// Reads a text such as "440 um". The decimal power of the unit is joined to the digits before they are rounded, so
/// that "440 um" is the double nearest to 440e-6.
Quantity parse_quantity(std::string_view text, Unit unit);

}  // namespace repose
