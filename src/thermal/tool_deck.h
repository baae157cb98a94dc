#pragma once

#include "deck/key.h"
#include "deck/key_reference.h"
#include "deck/read_described.h"
#include "thermal/tool_input.h"

namespace repose::thermal {

/// As read_described.
template <class D>
D read_tool_deck(const ToolInput& input, void (*check)(D&, DeckErrors&)) {
  return read_described<D>(input.deck.bytes, input.deck.name, input.overrides, check);
}

}  // namespace repose::thermal
