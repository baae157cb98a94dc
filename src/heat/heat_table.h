#pragma once

#include <cstddef>
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
  /// Of the specific heat between two points, from the first on: J/(kg K2).
  double slope(std::size_t first) const;

  std::vector<double> temperatures_;    ///< K
  std::vector<double> conductivities_;  ///< W/(m K)
  std::vector<double> specific_heats_;  ///< J/(kg K)
  std::vector<double> energies_;        ///< J/kg
};

}  // namespace repose
