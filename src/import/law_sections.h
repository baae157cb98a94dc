#pragma once

#include "import/deck_text.h"
#include "import/materials_used.h"

namespace repose {

/// [[material]], [[pair]] and [contact]. DeckError at the line of what lacks a property, or of a property that does not
/// have a value for each type.
void write_materials(DeckText& deck, const ImportedScene& scene, const MaterialsUsed& materials);
void write_contact(DeckText& deck, const ImportedScene& scene, const MaterialsUsed& materials);

}  // namespace repose
