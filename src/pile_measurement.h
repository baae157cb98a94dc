#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "comm/communicator.h"
#include "deck/deck.h"
#include "measurement/angle_of_repose.h"
#include "output/summary.h"
#include "simulation.h"

namespace repose {

/// Collective. All grains of this moment on rank 0, in the order of their ids; nothing elsewhere.
std::vector<Sphere> gather_grains(const Simulation& simulation);

/// The angle of repose of the pile among `grains` as the deck asks for it, with its picture in `picture` (PNG). Empty,
/// and no picture, when there is no pile. For rank 0; FileError when the picture cannot be written.
std::optional<AngleOfRepose> measure_angle_of_repose(const AngleOfReposeDeck& deck, std::span<const Sphere> grains,
                                                     const std::string& picture);

/// Collective. Angle of repose and picture of the pile of this moment, in the summary.
void summarise_pile(const Simulation& simulation, const std::string& picture, Summary& summary);

}  // namespace repose
