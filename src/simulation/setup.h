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

/// What a run of a deck begins with, besides its materials and walls.
struct SetUp {
  Insertion insertion;
  TimeStep time_step;
  double smallest = 0.0;             ///< m, radius of the smallest particle
  double growth = 1.0;               ///< greatest_growth
  std::optional<HeatTransfer> heat;  ///< none without [heat]; holds on to the materials
  Reach reach;
};

/// DeckError when particles do not fit, the time step is too long, a wall can move so far in one that it could pass the
/// smallest particle unseen (longest_way), or the domain is too small for how far particles reach.
SetUp set_up(const Deck& deck, const MaterialTable& materials, const std::vector<Wall>& walls,
             const ReadFile& read_file);

}  // namespace repose
