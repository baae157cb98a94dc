#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "deck/deck.h"
#include "scene/insertion/new_particles.h"

namespace repose {

/// Whether the bytes begin as those of an HDF5 file.
bool is_snapshot(const std::string& bytes);

/// The number of particles that had left the domain by then. FileError as below.
std::int64_t left_before_snapshot(const std::string& bytes, const std::string& file);

/// The particles of a snapshot (snapshot.h) from the bytes of its file, in the order of their ids, without numbers:
/// positions, velocities, spins, radii and materials, which the deck must have by the same names. What contacts
/// remember is not in a snapshot: they begin anew. FileError, beginning with `file`, when it is no snapshot; DeckError
/// when a material is unknown.
NewParticles parse_snapshot(const std::string& bytes, const std::string& file,
                            const std::vector<MaterialDeck>& materials);

}  // namespace repose
