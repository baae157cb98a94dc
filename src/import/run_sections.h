#pragma once

#include "import/deck_text.h"
#include "import/imported_scene.h"
#include "import/wall_sections.h"

namespace repose {

/// The box, and in directions that LIGGGHTS lets grow, as far beyond it as a grain can fall in the time of the script.
Extent domain_of(const ImportedScene& scene);
void write_domain(DeckText& deck, const ImportedScene& scene, const Extent& domain);

/// Shares of the critical times that the time step of the script may take.
struct TimeShares {
  double rayleigh = 1.0;
  double hertz = 1.0;
  double hooke = 1.0;
};

/// [time], the [[phase]] sections, [output] and [guards].
void write_time(DeckText& deck, const ImportedScene& scene, const TimeShares& shares);
void write_phases(DeckText& deck, const ImportedScene& scene, const WallNames& walls, const Extent& domain);
void write_output(DeckText& deck, const ImportedScene& scene);
void write_guards(DeckText& deck);

}  // namespace repose
