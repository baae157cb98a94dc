#pragma once

#include <optional>
#include <span>

#include "deck/deck.h"
#include "measurement/sphere.h"

namespace repose {

struct BulkDensity {
  std::optional<double> density;  ///< kg/m^3; empty when masses are not known
  double porosity = 0.0;          ///< where grains overlap they count twice
  double top = 0.0;               ///< z of the box's upper face, m

  template <class Self, class Visitor>
  static void describe_state(Self& self, Visitor& v) {
    v("density", self.density);
    v("porosity", self.porosity);
    v("top", self.top);
  }
};

/// Bulk density and porosity in the box of `deck`, whose upper face is lowered to `surface_gap` below the lowest place
/// of the bed's surface over it (docs/theory.md, "Bulk density"). `mass` (kg) is that of each grain, or empty. Images
/// across the periodic directions of `domain` count. The order of the grains does not matter. Empty when there is no
/// bed over the whole box or it is less than two mean diameters deep there.
std::optional<BulkDensity> bulk_density(const BulkDensityDeck& deck, const DomainDeck& domain,
                                        std::span<const Sphere> grains, std::span<const double> mass);

}  // namespace repose
