#pragma once

#include "deck/deck.h"
#include "measurement/wall_loads.h"

namespace repose {

/// Stresses in the plane between the halves of a shear cell, Pa.
struct ShearStress {
  double shear = 0.0;   ///< as it acts on the half whose walls are looked at
  double normal = 0.0;  ///< of compression
};

/// m2, of the plane: as given, or of the ring.
double shear_area(const ShearDeck& deck);

/// From what the grains do to the walls of one half (force, and torque about the origin of coordinates) and the weight
/// (N, towards where gravity points) of the grains below and above the plane: the half stands still or moves steadily,
/// so that the plane bears what the walls bear and the weight of the grains between it and them. The walls below the
/// plane are pressed downwards. Of a ring the shear stress is torque / (area x mean radius), as if it were the same
/// everywhere, with the mean radius 2/3 (R^3 - r^3) / (R^2 - r^2) (D. Schulze, Powders and Bulk Solids, Springer 2008,
/// chapter 4).
ShearStress shear_stress(const ShearDeck& deck, const WallLoad& load, const Vec3& weight_below,
                         const Vec3& weight_above);

}  // namespace repose
