#pragma once

#include <cstdint>
#include <span>

#include "comm/communicator.h"
#include "contact/wall_contacts.h"
#include "neighbours/pair_lists.h"
#include "scene/particles/materials.h"
#include "scene/particles/particles.h"

namespace repose {

/// Mechanical energy of all particles in the domain that are not held, J. The elastic part is what the springs hold:
/// 2/5 k_n delta^2 of the Hertz force (its work; 1/2 k_n delta^2 of Hooke's), k_t xi^2 / 2 and M^2 / (2 k_r), with
/// JKR the work of its force, which is negative where adhesion holds; cohesion by areas is left out. The law is not
/// exactly conservative, since k_t and k_r grow and shrink with the overlap.
struct Energies {
  double translational = 0.0;
  double rotational = 0.0;
  double gravitational = 0.0;  ///< -m g.x, without the periodic directions, in which height has no meaning
  double elastic = 0.0;
  double total() const { return translational + rotational + gravitational + elastic; }
};

/// Collective; the same bits on any number of ranks.
Energies measure_energies(const Communicator& comm, const Vec3& gravity, const MaterialTable& materials,
                          const Particles& particles, const PairLists& pairs, std::span<const Wall> walls,
                          const WallContacts& wall_contacts);

/// Collective. Mean translational kinetic energy per particle in the domain that is not held, J; 0 without particles.
double mean_kinetic_energy(const Communicator& comm, const MaterialTable& materials, const Particles& particles);

/// Collective. Touching pairs and touched wall features.
struct ContactCount {
  std::int64_t pairs = 0;
  std::int64_t walls = 0;
};
ContactCount count_contacts(const Communicator& comm, const Particles& particles, const PairLists& pairs,
                            std::span<const Wall> walls, const WallContacts& wall_contacts);

}  // namespace repose
