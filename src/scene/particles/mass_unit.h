#pragma once

#include <cmath>
#include <cstdint>

namespace repose {

/// Masses are summed as integers of a unit so that no sum depends on its order. The unit is a power of two, such that
/// the mass of all particles of the run is below 2^61 of it.
class MassUnit {
 public:
  explicit MassUnit(double total_mass) { std::frexp(total_mass, &exponent_); }
  std::int64_t count(double mass) const {
    return static_cast<std::int64_t>(std::rint(std::ldexp(mass, 61 - exponent_)));
  }
  double kilograms(std::int64_t units) const { return std::ldexp(static_cast<double>(units), exponent_ - 61); }

 private:
  int exponent_ = 0;
};

}  // namespace repose
