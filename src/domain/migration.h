#pragma once

#include "comm/communicator.h"
#include "domain/decomposition.h"
#include "scene/particles/contact_memory.h"
#include "scene/particles/particles.h"

namespace repose {

/// Collective. Drops all ghosts and all parked particles, sends every owned particle to the rank that owns its
/// position, with everything it remembers of its contacts, and sorts what each rank then owns by layers
/// (layer_order.h). Force sums are not kept: lists are rebuilt between the drift and the next evaluation of the forces.
void migrate(const Communicator& comm, const Decomposition& decomposition, Particles& particles, ContactMemory& memory);

}  // namespace repose
