#pragma once

#include <optional>

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
/// asks for to the output directory. The summary is complete on rank 0; there is none when a restart finds the complete
/// results of this deck. DeckError, PhysicsError or FileError on all ranks alike; also Stopped, with a checkpoint in
/// the directory, as soon as `stop_asked` gives a reason on any rank.
std::optional<Summary> run_deck(const Communicator& comm, const Deck& deck, const ReadFile& read_file,
                                VectorLevel level, const OutputOptions& options, const StopAsked& stop_asked = {});

}  // namespace repose
