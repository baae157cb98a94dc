#pragma once

#include "comm/communicator.h"
#include "deck/deck.h"
#include "recorder.h"
#include "scene/insertion.h"

namespace repose {

/// Collective. Runs a checked deck from its first phase to its last and writes everything it asks for to the output
/// directory. The summary is complete on rank 0. DeckError, PhysicsError or FileError on all ranks alike.
Summary run_deck(const Communicator& comm, const Deck& deck, const ReadFile& read_file, VectorLevel level,
                 const OutputOptions& options);

}  // namespace repose
