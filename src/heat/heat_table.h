#pragma once

#include <vector>

#include "deck/contact_keys.h"

namespace repose {

/// Conductivity and specific heat of a solid over its temperature: linear between the points of a table, constant
/// beyond them.
class HeatTable {
 public:
  /// Of a material whose thermal properties are given.
  explicit HeatTable(const MaterialDeck& material);

  double conductivity(double temperature) const;   ///< W/(m K) at K
  double specific_heat(double temperature) const;  ///< J/(kg K) at K
  /// The integral of the specific heat from 0 K to `temperature` in K, J/kg.
  double energy(double temperature) const;
  /// The temperature in K with that energy in J/kg: the inverse of the above.
  double temperature(double energy) const;

 private:
  struct Point {
    double temperature;    ///< K
    double conductivity;   ///< W/(m K)
    double specific_heat;  ///< J/(kg K)
    double energy = 0.0;   ///< J/kg
  };
  double between(double temperature, double Point::*property) const;

  std::vector<Point> points_;
};

}  // namespace repose
