#pragma once

#include <cstdint>
#include <span>

#include "base/vector_level.h"
#include "neighbours/contact_block.h"
#include "scene/materials.h"
#include "scene/particles.h"

namespace repose {

/// What went wrong in a pair loop, as counts; the caller looks for the culprit.
struct PairLoopAlarms {
  std::int64_t too_deep = 0;      ///< contacts whose overlap exceeds the bound
  std::int64_t out_of_range = 0;  ///< blocks with a force (or NaN) that the fixed-point sum cannot hold
  bool any() const { return too_deep + out_of_range > 0; }
};

/// Evaluates the contact law on every lane of `blocks` and adds the forces and torques to the sums of both particles.
/// Histories advance by `dt` s. `max_overlap` is the bound as a share of the smaller radius. `fetch`, if not empty, is
/// that of the blocks: it changes nothing but the time.
PairLoopAlarms evaluate_pairs(VectorLevel level, std::span<ContactBlock> blocks, const FetchList& fetch,
                              const PairParameters& pair, double dt, double max_overlap, const ParticleRecord* records,
                              ForceSum* sums);

}  // namespace repose
