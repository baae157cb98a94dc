#pragma once

#include <string>
#include <vector>

#include "deck/deck.h"

namespace repose {

/// Reads and checks a deck. `text` is its TOML, `path` its name in messages, `overrides` are "key=value" texts that
/// replace single keys before the checks. A number is SI; a text such as "440 um" carries its unit. Keys that follow
/// from others (a fill's spacing, the pile's max_height) are filled in. Throws DeckError with the first error by
/// position: "path:line:column: what is wrong, what would be right", or "--set key=value: ...".
Deck read_deck(const std::string& text, const std::string& path, const std::vector<std::string>& overrides);

/// The same of the resolved deck that a result has with it: of an earlier version, perhaps, which did not refuse what
/// does not go together, so only its keys are checked.
Deck read_written_deck(const std::string& text, const std::string& path, const std::vector<std::string>& overrides);

}  // namespace repose
