#pragma once

#include <string>

#include "comm/communicator.h"

namespace repose {

/// Collective. Whether the directory holds the complete results of this deck (resolved, TOML). DeckError, with the keys
/// that differ, when they are those of another deck; what only says how results are written may differ.
bool is_finished(const Communicator& comm, const std::string& directory, const std::string& resolved_deck);

}  // namespace repose
