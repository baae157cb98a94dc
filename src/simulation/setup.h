#pragma once

#include <optional>
#include <string>
#include <vector>

#include "deck/deck.h"
#include "heat/heat_transfer.h"
#include "integration/time_step.h"
#include "scene/insertion/insertion.h"
#include "scene/particles/materials.h"
#include "scene/walls/wall.h"

/// Pieces of the set-up that a run and `repose check` share.
namespace repose {

std::vector<Wall> make_walls(const Deck& deck, const MaterialTable& materials, const ReadFile& read_file);

/// What the deck brings in (scene/insertion.h), with snapshots read by the output's own reader. DeckError also when a
/// measurement asks for a particle that there is not.
Insertion insert_particles_of(const Deck& deck, const std::vector<Wall>& walls, const ReadFile& read_file);

/// Of all particles, present and planned.
SmallestRadii smallest_radii(const Insertion& insertion, std::size_t materials);

/// DeckError when a wall's motions can take it further in a time step of `dt` s than the smallest particle may move
/// (longest_way): it could pass particles unseen.
void check_wall_speeds(const Deck& deck, const std::vector<Wall>& walls, const MaterialTable& materials,
                       const SmallestRadii& radii, double dt);

/// Mass in kg of all particles, present and planned.
double planned_mass(const Insertion& insertion, const MaterialTable& materials);

/// The most by which the diameter of a particle can have grown in all phases. DeckError when that is beyond tenfold.
double greatest_growth(const Deck& deck, double timestep);

/// How far particles may reach in a run.
struct Reach {
  double adhesion_range = 0.0;  ///< m, over which particles hold together that do not touch
  double heat_share = 0.0;      ///< of the radius, over which heat is conducted through the gap
  double longest_skin = 0.0;    ///< m, that the domain leaves to the lists
};

/// DeckError when the domain is too small for particles that reach so far, or when grown ones would meet two walls with
/// one another. Radii in m of the smallest and the largest particle at the start, and what greatest_growth says.
Reach reach_of(const Deck& deck, const std::vector<Wall>& walls, const MaterialTable& materials, double smallest,
               double largest, double growth, const std::optional<HeatTransfer>& heat);

}  // namespace repose
