#pragma once

#include "import/deck_text.h"
#include "import/materials_used.h"

namespace repose {

/// [[material]] and [[pair]]; [contact]. DeckError at the line of what lacks a property, or of a property that does not
/// have a value for each type.
void write_materials(DeckText& deck, const ImportedScene& scene, const MaterialsUsed& materials);
/// The properties (fix property/global) that a model uses.
std::set<std::string> properties_of(const ScriptModel& model);
void write_contact(DeckText& deck, const ImportedScene& scene, const MaterialsUsed& materials);

}  // namespace repose
