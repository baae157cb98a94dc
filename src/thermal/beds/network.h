#pragma once

#include <cstddef>
#include <vector>

#include "thermal/beds/grain_links.h"

namespace repose::thermal {

/// The box in which the conductivity is measured.
struct MeasuringBox {
  Point min;
  Point max;
  std::size_t axis = 2;  ///< of the gradient
};

/// What the network conducts.
struct NetworkResult {
  double conductivity = 0.0;  ///< W/(m K)
  double imbalance = 0.0;     ///< heat into the cold face over that out of the hot one, less 1
  std::size_t held = 0;       ///< grains at a given temperature
  std::size_t free = 0;       ///< grains whose temperature is solved for
  std::size_t floating = 0;   ///< grains without a way to a held one
};

/// Steady conduction between two faces of the box (theory T.19 to T.21). Grains beyond the box along its axis are held
/// at the temperature that a uniform gradient of 1 K/m gives their centres; the balance of heat of each other grain is
/// one row of a sparse symmetric system. The conductivity is the mean flux in the box: each link's heat by the part of
/// its way along the axis that lies inside. In a periodic direction the box must span the period. `conductance` in W/K
/// of each link. DeckError when no grain lies beyond a face, PhysicsError when the solver does not converge.
NetworkResult conduct(const std::vector<Grain>& grains, const std::vector<Link>& links,
                      const std::vector<double>& conductance, const MeasuringBox& box, const Periods& periods);

/// The share of the box that no grain takes: chords of the grains on a grid of lines along the axis, `lines` in each of
/// the other directions; those of overlapping grains count twice.
double porosity_in(const std::vector<Grain>& grains, const MeasuringBox& box, const Periods& periods, int lines);

}  // namespace repose::thermal
