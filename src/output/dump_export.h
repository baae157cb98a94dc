#pragma once

#include <string>

#include "output/file_contents.h"

namespace repose {

/// Particles as a text dump of style custom (docs.lammps.org/dump.html), which `read_dump` of LIGGGHTS and LAMMPS and
/// `repose import --dump` read: id (from 1 on), type (place of the material, from 1 on), x, y, z, vx, vy, vz, omegax,
/// omegay, omegaz, radius, mass; SI, in numbers that read back exactly. The box is the domain.
std::string dump_text(const SnapshotParticles& snapshot);

/// Particles as an H5MD file (version 1.1, https://www.nongnu.org/h5md/h5md.html) with one step of the group
/// /particles/grains: position, velocity, angular_velocity, in a run with heat temperature, and without time id,
/// species, mass and radius; SI. These are the bytes of the file.
std::string h5md_bytes(const SnapshotParticles& snapshot);

}  // namespace repose
