#pragma once

#include <string>

#include "comm/communicator.h"
#include "deck/deck.h"

namespace repose {

/// Collective. Measures the grains in `file`, a snapshot or a CSV, as the sections [measurement.discharge],
/// [measurement.angle_of_repose] and [measurement.scattering] of the deck ask, and returns the figures as lines for a
/// person, on rank 0, which does all the work. With an `output` directory also writes measurement.json and the pictures
/// there. DeckError when the deck asks for none of these, or something cannot be measured; FileError.
std::string measure_file(const Communicator& comm, const Deck& deck, const std::string& file,
                         const std::string& output);

}  // namespace repose
