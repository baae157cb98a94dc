#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "comm/communicator.h"
#include "deck/deck.h"
#include "measurement/angle_of_repose.h"
#include "output/run_log.h"
#include "output/summary.h"
#include "simulation/simulation.h"

namespace repose {

/// Collective. All grains of this moment on rank 0, in the order of their ids; nothing elsewhere.
std::vector<Sphere> gather_grains(const Simulation& simulation);

inline constexpr const char* silhouette_file = "silhouette.png";
inline constexpr const char* top_view_file = "top_view.png";

/// The angle of repose of the pile among `grains` as the deck asks for it, in the summary, and its picture at the path
/// `picture` (PNG; empty: none). Nothing when there is no pile. For rank 0; DeckError when it cannot be measured,
/// FileError when the picture cannot be written.
void measure_angle_of_repose(const AngleOfReposeDeck& deck, std::span<const Sphere> grains, const std::string& picture,
                             PileSummary& summary);

/// The same of what lies around the pile, `left_domain` grains being gone.
void measure_scattering(const ScatteringDeck& deck, std::span<const Sphere> grains, std::int64_t left_domain,
                        const std::string& picture, PileSummary& summary);

/// Collective. What the deck asks for of the pile of this moment, in the summary, of which `left` and `plugged` are
/// known, and the pictures in `directory`. A figure that cannot be measured costs a warning.
void summarise_pile(const Simulation& simulation, const std::string& directory, const RunLog& log, Summary& summary);

/// The figures as lines for a person; empty when there are none.
std::string pile_lines(const PileSummary& pile);

}  // namespace repose
