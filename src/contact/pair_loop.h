#pragma once

#include <span>

#include "base/vector_level.h"
#include "contact/contact_alarms.h"
#include "neighbours/contact_block.h"
#include "scene/particles/materials.h"
#include "scene/particles/particles.h"

namespace repose {

/// Evaluates the contact law on every lane of `blocks` and adds the forces and torques to the sums of both particles.
/// Histories advance by `dt` s. `max_overlap` is the bound as a share of the smaller radius.
ContactAlarms evaluate_pairs(VectorLevel level, std::span<ContactBlock> blocks, const PairParameters& pair, double dt,
                             double max_overlap, const ParticleRecord* records, ForceSum* sums);

}  // namespace repose
