#pragma once

#include <vector>

namespace repose {

/// Conductivity and modified free path of air over temperature, linear between points 5 K apart and constant beyond
/// 250 K and 2000 K. Their logarithms and powers are those of the C library, whose last bits are not the same on all
/// processors; rounded to 32 bits the points are.
class GasTable {
 public:
  struct Point {
    double conductivity;  ///< W/(m K)
    double free_path;     ///< m
  };
  /// `pressure` in Pa.
  explicit GasTable(double pressure);
  /// At a temperature in K.
  Point at(double temperature) const;

 private:
  std::vector<Point> points_;
};

}  // namespace repose
