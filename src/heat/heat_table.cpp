#include "heat/heat_table.h"

#include <algorithm>
#include <cmath>

#include "base/interpolate.h"

namespace repose {
namespace {

/// How many of the rising values are at most x.
std::size_t up_to(const std::vector<double>& values, double x) {
  return static_cast<std::size_t>(std::upper_bound(values.begin(), values.end(), x) - values.begin());
}

}  // namespace

HeatTable::HeatTable(const MaterialDeck& material)
    : temperatures_(material.heat_table.temperatures),
      conductivities_(material.heat_table.conductivities),
      specific_heats_(material.heat_table.specific_heats) {
  if (!material.heat_table.enabled) {
    temperatures_ = {1.0};
    conductivities_ = {material.conductivity};
    specific_heats_ = {material.specific_heat};
  }
  energies_ = {temperatures_[0] * specific_heats_[0]};
  for (std::size_t i = 1; i < temperatures_.size(); ++i) {
    energies_.push_back(energies_[i - 1] + 0.5 * (specific_heats_[i - 1] + specific_heats_[i]) *
                                               (temperatures_[i] - temperatures_[i - 1]));
  }
}

double HeatTable::conductivity(double temperature) const {
  return interpolate(temperatures_, conductivities_, temperature);
}

double HeatTable::specific_heat(double temperature) const {
  return interpolate(temperatures_, specific_heats_, temperature);
}

double HeatTable::slope(std::size_t first) const {
  return (specific_heats_[first + 1] - specific_heats_[first]) / (temperatures_[first + 1] - temperatures_[first]);
}

double HeatTable::energy(double temperature) const {
  const std::size_t above = up_to(temperatures_, temperature);
  if (above == 0) return temperature * specific_heats_[0];
  const std::size_t a = above - 1;
  const double way = temperature - temperatures_[a];
  if (above == temperatures_.size()) return energies_[a] + specific_heats_[a] * way;
  return energies_[a] + (specific_heats_[a] + 0.5 * slope(a) * way) * way;
}

double HeatTable::temperature(double energy) const {
  const std::size_t above = up_to(energies_, energy);
  if (above == 0) return energy / specific_heats_[0];
  const std::size_t a = above - 1;
  const double rest = energy - energies_[a];
  if (above == energies_.size()) return temperatures_[a] + rest / specific_heats_[a];
  const double root = std::sqrt(specific_heats_[a] * specific_heats_[a] + 2.0 * slope(a) * rest);
  return temperatures_[a] + 2.0 * rest / (specific_heats_[a] + root);  // of the two forms, that without a difference
}

}  // namespace repose
