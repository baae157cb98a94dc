#include "heat/conductance.h"

#include <algorithm>
#include <cmath>

#include "base/math.h"
#include "base/root.h"

namespace repose {

namespace {

/// Simulated over true effective modulus of two materials: compliances add.
double stiffness_ratio(const MaterialDeck& a, const MaterialDeck& b) {
  const auto compliance = [](const MaterialDeck& m) {
    return (1.0 - m.poisson_ratio * m.poisson_ratio) / m.youngs_modulus;
  };
  const double share_of_b = compliance(b) / (compliance(a) + compliance(b));
  return a.stiffness_ratio + share_of_b * (b.stiffness_ratio - a.stiffness_ratio);
}

}  // namespace

Conductance::Conductance(const Deck& deck) : deck_(deck.heat) {
  for (const MaterialDeck& m : deck.materials) {
    tables_.emplace_back(m);
    emissivity_.push_back(m.emissivity);
  }
  for (const MaterialDeck& a : deck.materials) {
    for (const MaterialDeck& b : deck.materials) stiffness_root_.push_back(odd_root<3>(stiffness_ratio(a, b)));
  }
  if (deck_.gas == GapGas::air) gas_.emplace(deck_.pressure);
}

/// Radius in m of the circle by which a contact conducts. Hertz: as thermal network has it; intersection: that of the
/// circle in which the spheres cut, by its area as LIGGGHTS's heat/gran has it. Both are those of grains with their
/// true stiffness, whose overlap is smaller by the square of the root.
double Conductance::contact_circle(double r1, double r2, double distance, double stiffness_root) const {
  const double overlap = r1 + r2 - distance;
  if (!(overlap > 0.0)) return 0.0;
  if (deck_.conductance == ContactConductance::hertz) return contact_radius_by_root(r1, r2, overlap, stiffness_root);
  const double d = r1 + r2 - overlap * stiffness_root * stiffness_root;
  const double product = (d - r1 - r2) * (d + r1 - r2) * (d - r1 + r2) * (d + r1 + r2);
  return 0.5 * std::sqrt(std::max(0.0, -product)) / d;
}

/// W/K through the circle of the contact.
double Conductance::through_contact(const GrainPair& pair) const {
  const double conductance = contact_conductance(pair);
  return deck_.conductance == ContactConductance::hertz ? conductance : std::sqrt(pi) * conductance;
}

/// What is in the gap of two bodies, at their mean temperature.
GapFill Conductance::fill_between(const WarmBody& a, const WarmBody& b) const {
  const double temperature = 0.5 * (a.temperature + b.temperature);
  GapFill fill;
  if (deck_.radiation)
    fill.radiation = radiative_coefficient(temperature, emissivity_[a.material], emissivity_[b.material]);
  if (!gas_) return fill;
  const GasTable::Point gas = gas_->at(temperature);
  fill.conductivity = gas.conductivity;
  fill.free_path = gas.free_path;
  return fill;
}

double Conductance::of_pair(const WarmBody& first, const WarmBody& second, double distance) const {
  const double gap = distance - first.radius - second.radius;
  if (gap > reach_share() * (first.radius + second.radius) || (gap >= 0.0 && !crosses_gaps(deck_))) return 0.0;
  const double root = stiffness_root_[first.material * tables_.size() + second.material];
  const GrainPair pair{.radius_1 = first.radius,
                       .radius_2 = second.radius,
                       .conductivity_1 = tables_[first.material].conductivity(first.temperature),
                       .conductivity_2 = tables_[second.material].conductivity(second.temperature),
                       .gap = gap,
                       .contact_radius = contact_circle(first.radius, second.radius, distance, root)};
  const double contact = through_contact(pair);
  if (!crosses_gaps(deck_)) return contact;
  return contact + gap_conductance(pair, fill_between(first, second), deck_.porosity);
}

double Conductance::of_wall(const WarmBody& grain, const WarmBody& wall, double distance) const {
  const double r = grain.radius;
  const double gap = distance - r;
  if (gap > reach_share() * r || (gap >= 0.0 && !crosses_gaps(deck_))) return 0.0;
  const double root = stiffness_root_[grain.material * tables_.size() + wall.material];
  GrainPair mirrored{.radius_1 = r,
                     .radius_2 = r,
                     .conductivity_1 = tables_[grain.material].conductivity(grain.temperature),
                     .conductivity_2 = tables_[wall.material].conductivity(wall.temperature),
                     .gap = 2.0 * gap,
                     .contact_radius = contact_circle(r, r, 2.0 * distance, root)};
  const double contact = through_contact(mirrored);
  if (!crosses_gaps(deck_)) return contact;
  // Half of the resistance to the mirror image, which lies across twice the gap: there the free path counts twice and
  // the radiation half.
  mirrored.conductivity_2 = mirrored.conductivity_1;
  GapFill fill = fill_between(grain, wall);
  fill.free_path *= 2.0;
  fill.radiation *= 0.5;
  return contact + 2.0 * gap_conductance(mirrored, fill, deck_.porosity);
}

}  // namespace repose
