#pragma once

#include "base/vector_level.h"
#include "comm/communicator.h"
#include "deck/deck.h"
#include "files/read_file.h"
#include "run/output_options.h"
#include "run/stop_request.h"
#include "scene/insertion/insertion.h"

namespace repose {

struct Summary;

/// Collective. Runs a checked deck from its first phase, or from a checkpoint, to its last and writes everything it
/// asks for to the output directory. The summary is complete on rank 0. DeckError, PhysicsError or FileError on all
/// ranks alike; also Stopped, with a checkpoint in the directory, as soon as `stop_asked` gives a reason on any rank.
Summary run_deck(const Communicator& comm, const Deck& deck, const ReadFile& read_file, VectorLevel level,
                 const OutputOptions& options, const StopAsked& stop_asked = {});

}  // namespace repose
