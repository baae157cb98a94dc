#pragma once

#include <string>

namespace repose {

/// What a file says: how one run goes, or what many runs are to find.
enum class DeckKind { run, calibration, sensitivity, validation };

/// Told from its sections alone, so that a file with mistakes is still met by the reader of its kind. DeckError when it
/// is no TOML.
DeckKind kind_of_deck(const std::string& text, const std::string& path);

/// DeckError, which names the command that is meant, when it is not the deck of one run.
void require_run_deck(const std::string& text, const std::string& path);

/// DeckError when a file for this command of studies ("calibrate") is the deck of one run or for repose validate.
void require_study(const std::string& text, const std::string& path, const std::string& command);

}  // namespace repose
