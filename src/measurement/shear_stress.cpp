#include "measurement/shear_stress.h"

#include <cmath>

#include "base/math.h"
#include "scene/walls/unit_vector.h"

namespace repose {
namespace {

/// N, with which the plane would have to be pulled at a lever of the mean radius; `weight` of the grains of that half,
/// which lie all round the axis of a ring.
double shear_force(const ShearDeck& deck, const WallLoad& load, const Vec3& weight) {
  if (deck.type == ShearType::translation) return dot(unit_vector(deck.direction), load.force - weight);
  const double inner = deck.inner_radius, outer = deck.outer_radius;
  const double mean_radius =
      2.0 / 3.0 * (outer * outer * outer - inner * inner * inner) / (outer * outer - inner * inner);
  return torque_about(load, deck.axis_origin, unit_vector(deck.axis_direction)) / mean_radius;
}

}  // namespace

double shear_area(const ShearDeck& deck) {
  if (deck.type == ShearType::translation) return deck.area;
  return pi * (deck.outer_radius * deck.outer_radius - deck.inner_radius * deck.inner_radius);
}

ShearStress shear_stress(const ShearDeck& deck, const WallLoad& load, const Vec3& weight_below,
                         const Vec3& weight_above) {
  const double area = shear_area(deck);
  const bool is_below = load.force.z < 0.0;
  const Vec3& weight = is_below ? weight_below : weight_above;
  const double normal = is_below ? weight.z - load.force.z : load.force.z - weight.z;
  return {shear_force(deck, load, weight) / area, normal / area};
}

}  // namespace repose
