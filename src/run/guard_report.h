#pragma once

#include <string>

#include "comm/communicator.h"
#include "deck/deck.h"
#include "run/output_options.h"
#include "simulation/guards.h"

namespace repose {

/// Collective. Writes the neighbourhood of a guard that was hit as neighbourhood_STEP.hdf, a snapshot of a few
/// particles, into the output folder, and returns the message with its path: or, when that fails, with what went wrong.
std::string with_neighbourhood(const Communicator& comm, const Deck& deck, const OutputOptions& options,
                               const Alarm& alarm);

}  // namespace repose
