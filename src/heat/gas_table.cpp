#include "heat/gas_table.h"

#include <algorithm>
#include <cmath>

#include "heat/air.h"
#include "heat/gas.h"

namespace repose {
namespace {

constexpr double spacing = 5.0;  // K; linear between them the conductivity is right to 1e-5

double rounded(double value) {
  constexpr int bits = 32;
  int exponent = 0;
  const double mantissa = std::frexp(value, &exponent);
  return std::ldexp(std::rint(std::ldexp(mantissa, bits)), exponent - bits);
}

}  // namespace

GasTable::GasTable(double pressure) {
  for (double t = air_min_temperature; t <= air_max_temperature; t += spacing) {
    const Gas gas = air_at(t, pressure);
    points_.push_back({rounded(gas.conductivity), rounded(modified_free_path(gas))});
  }
}

GasTable::Point GasTable::at(double temperature) const {
  const double place =
      (std::clamp(temperature, air_min_temperature, air_max_temperature) - air_min_temperature) / spacing;
  const auto below = std::min(static_cast<std::size_t>(place), points_.size() - 2);
  const double share = place - static_cast<double>(below);
  const Point& a = points_[below];
  const Point& b = points_[below + 1];
  return {a.conductivity + share * (b.conductivity - a.conductivity),
          a.free_path + share * (b.free_path - a.free_path)};
}

}  // namespace repose
