#pragma once

#include "comm/communicator.h"
#include "domain/exits.h"
#include "scene/particles/mass_unit.h"
#include "scene/particles/materials.h"
#include "scene/particles/particles.h"

namespace repose {

/// Collective. Mass in kg of the particles whose centre is below `orifice_height` (m), and of all that have left the
/// domain but through its top. Exact sums: the same bits on any number of ranks.
double discharged_mass(const Communicator& comm, double orifice_height, const MaterialTable& materials,
                       const MassUnit& unit, const Particles& particles, const ExitCount& left_here);

/// Collective. Mass in kg of everything in the domain and of all that has left it but through its top.
double total_mass(const Communicator& comm, const MaterialTable& materials, const MassUnit& unit,
                  const Particles& particles, const ExitCount& left_here);

}  // namespace repose
