#pragma once

#include <string>
#include <vector>

#include "deck/deck.h"
#include "scene/new_particles.h"

namespace repose {

/// The particles of a snapshot (snapshot.h) from the bytes of its file, in the order of their ids, without numbers:
/// positions, velocities, spins, radii and materials, which the deck must have by the same names. What contacts
/// remember is not in a snapshot: they begin anew. FileError, beginning with `file`, when it is no snapshot; DeckError
/// when a material is unknown.
NewParticles parse_snapshot(const std::string& bytes, const std::string& file,
                            const std::vector<MaterialDeck>& materials);

}  // namespace repose
