#pragma once

#include "comm/communicator.h"
#include "heat/heat_state.h"
#include "output/particle_table.h"
#include "scene/particles/materials.h"
#include "scene/particles/particles.h"

namespace repose {

/// Adds a particle behind the others of this rank; its mass from the density of its material.
void append_row(ParticleTable& table, std::int64_t id, const ParticleRecord& record, std::int32_t material,
                const MaterialTable& materials);

/// Collective. The particles in the domain as a table in the order of ids, block-distributed over the ranks by id out
/// of `inserted`; masses from the materials' densities, temperatures where the run has `heat`.
ParticleTable collect_particles(const Communicator& comm, const MaterialTable& materials, const Particles& particles,
                                std::int64_t inserted, const HeatState* heat = nullptr);

}  // namespace repose
