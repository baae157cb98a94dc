#pragma once

#include "import/deck_text.h"
#include "import/materials_used.h"
#include "import/wall_sections.h"

namespace repose {

/// The [[particles]] sections of what a script inserts. What comes otherwise than in LIGGGHTS is noted in the scene.
void write_insertions(DeckText& deck, ImportedScene& scene, const MaterialsUsed& materials, const WallNames& walls,
                      const Extent& domain);

}  // namespace repose
