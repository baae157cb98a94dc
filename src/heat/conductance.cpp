#include "heat/conductance.h"

#include <algorithm>
#include <cmath>

#include "base/math.h"

namespace repose {

Conductance::Conductance(const Deck& deck) : deck_(deck.heat) {
  for (const MaterialDeck& m : deck.materials) {
    tables_.emplace_back(m);
    emissivity_.push_back(m.emissivity);
  }
  for (const MaterialDeck& a : deck.materials) {
    // Compliances add: of materials that are simulated with the same modulus, a pair has the mean of their ratios.
    for (const MaterialDeck& b : deck.materials)
      stiffness_root_.push_back(std::cbrt(0.5 * (a.stiffness_ratio + b.stiffness_ratio)));
  }
  if (deck_.gas == GapGas::air) gas_.emplace(deck_.pressure);
}

/// Radius in m of the circle by which a contact conducts. Hertz: as thermal network has it; intersection: that of the
/// circle in which the spheres cut, by its area as LIGGGHTS's heat/gran has it.
double Conductance::contact_circle(double r1, double r2, double distance, double stiffness_root) const {
  const double overlap = r1 + r2 - distance;
  if (!(overlap > 0.0)) return 0.0;
  if (deck_.conductance == ContactConductance::hertz) return std::sqrt(r1 * r2 / (r1 + r2) * overlap) * stiffness_root;
  const double product = (distance - r1 - r2) * (distance + r1 - r2) * (distance - r1 + r2) * (distance + r1 + r2);
  return 0.5 * std::sqrt(std::max(0.0, -product)) / distance;
}

double Conductance::radiation_between(const WarmBody& a, const WarmBody& b) const {
  if (!deck_.radiation) return 0.0;
  return radiative_coefficient(0.5 * (a.temperature + b.temperature), emissivity_[a.material], emissivity_[b.material]);
}

double Conductance::across_gap(const GrainPair& pair, double temperature, double radiation) const {
  GapFill fill{.conductivity = 0.0, .free_path = 0.0, .radiation = radiation};
  if (gas_) {
    const GasTable::Point gas = gas_->at(temperature);
    fill.conductivity = gas.conductivity;
    fill.free_path = gas.free_path;
  }
  return gap_conductance(pair, fill, deck_.porosity);
}

double Conductance::of_pair(const WarmBody& first, const WarmBody& second, double distance) const {
  const double gap = distance - first.radius - second.radius;
  if (gap > reach_share() * (first.radius + second.radius) || (gap >= 0.0 && !crosses_gaps(deck_))) return 0.0;
  GrainPair pair{.radius_1 = first.radius,
                 .radius_2 = second.radius,
                 .conductivity_1 = tables_[first.material].conductivity(first.temperature),
                 .conductivity_2 = tables_[second.material].conductivity(second.temperature),
                 .gap = gap};
  const double root = stiffness_root_[first.material * tables_.size() + second.material];
  pair.contact_radius = contact_circle(first.radius, second.radius, distance, root);
  double conductance = 0.0;
  if (deck_.conductance == ContactConductance::hertz) {
    conductance = pair.contact_radius > 0.0 ? contact_conductance(pair) : 0.0;
  } else {
    const double k = pair.conductivity_1 * pair.conductivity_2 / (pair.conductivity_1 + pair.conductivity_2);
    conductance = 4.0 * k * std::sqrt(pi) * pair.contact_radius;
  }
  if (!crosses_gaps(deck_)) return conductance;
  const double temperature = 0.5 * (first.temperature + second.temperature);
  return conductance + across_gap(pair, temperature, radiation_between(first, second));
}

double Conductance::of_wall(const WarmBody& grain, const WarmBody& wall, double distance) const {
  const double gap = distance - grain.radius;
  if (gap > reach_share() * grain.radius || (gap >= 0.0 && !crosses_gaps(deck_))) return 0.0;
  const double k_grain = tables_[grain.material].conductivity(grain.temperature);
  const double k_wall = tables_[wall.material].conductivity(wall.temperature);
  const double k = k_grain * k_wall / (k_grain + k_wall);
  const double root = stiffness_root_[grain.material * tables_.size() + wall.material];
  double circle = 0.0;
  double conductance = 0.0;
  if (gap < 0.0 && deck_.conductance == ContactConductance::hertz) {
    circle = std::sqrt(grain.radius * -gap) * root;
    conductance = 4.0 * k * circle;
  } else if (gap < 0.0) {
    circle = std::sqrt((grain.radius - distance) * (grain.radius + distance));
    conductance = 4.0 * k * std::sqrt(pi) * circle;
  }
  if (!crosses_gaps(deck_)) return conductance;
  const GrainPair mirrored{.radius_1 = grain.radius,
                           .radius_2 = grain.radius,
                           .conductivity_1 = k_grain,
                           .conductivity_2 = k_grain,
                           .gap = 2.0 * gap,
                           .contact_radius = circle};
  // Half of the resistance: over twice the gap with twice the free path, and half of the radiation.
  GapFill fill{.conductivity = 0.0, .free_path = 0.0, .radiation = 0.5 * radiation_between(grain, wall)};
  if (gas_) {
    const GasTable::Point gas = gas_->at(0.5 * (grain.temperature + wall.temperature));
    fill.conductivity = gas.conductivity;
    fill.free_path = 2.0 * gas.free_path;
  }
  return conductance + 2.0 * gap_conductance(mirrored, fill, deck_.porosity);
}

}  // namespace repose
