#pragma once

#include "import/deck_text.h"
#include "import/materials_used.h"

namespace repose {

/// [[material]] and [[pair]]; [contact]. DeckError at the line of what lacks a property, or of a property that does not
/// have a value for each type.
void write_materials(DeckText& deck, const ImportedScene& scene, const MaterialsUsed& materials);
/// The properties (fix property/global) that a model uses, and heat if there is any.
std::set<std::string> properties_of(const ImportedScene& scene, const ScriptModel& model);
/// [heat], if grains carry any; notes what is not quite LIGGGHTS's.
void write_heat(DeckText& deck, ImportedScene& scene, const ScriptModel& model);
void write_contact(DeckText& deck, const ImportedScene& scene, const MaterialsUsed& materials);

}  // namespace repose
