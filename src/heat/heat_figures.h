#pragma once

#include <vector>

#include "heat/heat_transfer.h"

namespace repose {

/// The heat of all particles in the domain at a moment.
struct HeatFigures {
  double stored = 0.0;        ///< J, from 0 K on
  double mean = unset;        ///< K, by mass; NaN without particles, as the two below
  double lowest = unset;      ///< K
  double highest = unset;     ///< K
  std::vector<double> walls;  ///< J that each wall has given so far
};

/// Collective; the same bits on any number of ranks. PhysicsError when the particles have not the heat that they must
/// have by all that has come and gone: then some was lost.
HeatFigures measure_heat(const Communicator& comm, const MaterialTable& materials, const HeatTransfer& heat,
                         const Particles& particles);

}  // namespace repose
