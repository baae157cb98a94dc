#pragma once

#include "import/deck_text.h"
#include "import/materials_used.h"

namespace repose {

/// When a wall is there: which runs add and remove it, by its name in the deck.
struct WallPresence {
  std::string name;
  std::size_t from = 0;
  std::size_t until = never_removed;
};

/// Walls as the deck names them.
struct WallNames {
  std::vector<WallPresence> present;
  std::map<std::string, std::string> faces;       ///< by the mesh through which grains enter
  std::map<std::string, std::string> mesh_files;  ///< file of the script -> beside the deck
};

/// "run_1" for the first run of the script.
std::string phase_name(std::size_t run);

/// The [[wall]] sections with their motions, for a domain.
WallNames write_walls(DeckText& deck, ImportedScene& scene, const MaterialsUsed& materials, const Extent& domain);

}  // namespace repose
