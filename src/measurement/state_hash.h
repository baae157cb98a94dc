#pragma once

#include <string>

#include "comm/communicator.h"
#include "contact/wall_contacts.h"
#include "neighbours/pair_lists.h"
#include "scene/particles/particles.h"

namespace repose {

/// Collective. 128-bit hash, as 32 hexadecimal digits, over id, position, velocity, spin and contact histories of all
/// particles in the domain. Each particle's digest includes its id and its contacts in the order of their partners; the
/// digests are added up, so that the hash is that of the particles in id order however they are distributed.
std::string state_hash(const Communicator& comm, const Particles& particles, const PairLists& pairs,
                       const WallContacts& wall_contacts);

}  // namespace repose
