#pragma once

#include <vector>

#include "deck/deck.h"
#include "scene/read_file.h"
#include "scene/wall.h"

namespace repose {

/// Particles at the start of a run, in the order of their ids 0, 1, 2, ...
struct NewParticles {
  std::vector<Vec3> position;  ///< m
  std::vector<Vec3> velocity;  ///< m/s
  std::vector<Vec3> spin;      ///< rad/s
  std::vector<double> radius;  ///< m
  std::vector<int> material;   ///< index into the deck's materials

  std::size_t size() const { return position.size(); }
};

/// All particles of the deck, the blocks [[particles]] one after the other. A function of its arguments alone: the same
/// on every rank. DeckError when a block does not fit into its region, a particle is outside the domain, reaches into
/// another or into a present wall by more than the guard `max_overlap` of the smaller radius, or when filled blocks
/// overlap with others at all.
NewParticles insert_particles(const Deck& deck, const std::vector<Wall>& walls, const ReadFile& read_file);

}  // namespace repose
