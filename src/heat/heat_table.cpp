#include "heat/heat_table.h"

#include <algorithm>
#include <cmath>

namespace repose {

HeatTable::HeatTable(const MaterialDeck& material) {
  const HeatTableDeck& table = material.heat_table;
  if (table.enabled) {
    for (std::size_t i = 0; i < table.temperatures.size(); ++i)
      points_.push_back({table.temperatures[i], table.conductivities[i], table.specific_heats[i]});
  } else {
    points_.push_back({1.0, material.conductivity, material.specific_heat});
  }
  points_[0].energy = points_[0].temperature * points_[0].specific_heat;
  for (std::size_t i = 1; i < points_.size(); ++i) {
    const Point& before = points_[i - 1];
    points_[i].energy = before.energy + 0.5 * (before.specific_heat + points_[i].specific_heat) *
                                            (points_[i].temperature - before.temperature);
  }
}

double HeatTable::between(double temperature, double Point::*property) const {
  if (temperature <= points_.front().temperature) return points_.front().*property;
  if (temperature >= points_.back().temperature) return points_.back().*property;
  const auto above = std::upper_bound(points_.begin(), points_.end(), temperature,
                                      [](double t, const Point& p) { return t < p.temperature; });
  const Point& a = *(above - 1);
  const double share = (temperature - a.temperature) / (above->temperature - a.temperature);
  return a.*property + share * ((*above).*property - a.*property);
}

double HeatTable::conductivity(double temperature) const { return between(temperature, &Point::conductivity); }

double HeatTable::specific_heat(double temperature) const { return between(temperature, &Point::specific_heat); }

double HeatTable::energy(double temperature) const {
  const auto above = std::upper_bound(points_.begin(), points_.end(), temperature,
                                      [](double t, const Point& p) { return t < p.temperature; });
  if (above == points_.begin()) return temperature * above->specific_heat;
  const Point& a = *(above - 1);
  const double way = temperature - a.temperature;
  if (above == points_.end()) return a.energy + a.specific_heat * way;
  const double slope = (above->specific_heat - a.specific_heat) / (above->temperature - a.temperature);
  return a.energy + (a.specific_heat + 0.5 * slope * way) * way;
}

double HeatTable::temperature(double energy) const {
  const auto above =
      std::upper_bound(points_.begin(), points_.end(), energy, [](double e, const Point& p) { return e < p.energy; });
  if (above == points_.begin()) return energy / above->specific_heat;
  const Point& a = *(above - 1);
  const double rest = energy - a.energy;
  if (above == points_.end()) return a.temperature + rest / a.specific_heat;
  const double slope = (above->specific_heat - a.specific_heat) / (above->temperature - a.temperature);
  const double root = std::sqrt(a.specific_heat * a.specific_heat + 2.0 * slope * rest);
  return a.temperature + 2.0 * rest / (a.specific_heat + root);  // of the two forms, that without a difference
}

}  // namespace repose
