#pragma once

#include "import/translate.h"

namespace repose {

/// `fix heat/gran` and `fix heat/gran/conduction`
void translate_heat(Translation& to, Words& words);

/// `set STYLE ID property/atom NAME VALUE`, from the name on.
void set_atom_property(Translation& to, Words& words, const std::string& style, const std::string& id);

}  // namespace repose
