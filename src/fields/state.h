#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "deck/deck.h"
#include "files/read_file.h"
#include "scene/particles/contact_memory.h"
#include "scene/particles/materials.h"
#include "scene/particles/particles.h"
#include "scene/walls/wall.h"

namespace repose::fields {

/// Grains and walls at one time, as a snapshot or a checkpoint tells them.
struct State {
  explicit State(const Deck& of) : deck(of), materials(of) {}

  Deck deck;
  MaterialTable materials;
  Particles particles;  ///< all, in the order of their ids
  ContactMemory memory;
  bool remembers = false;  ///< true for a checkpoint: `memory` is what the contacts remember; else it is empty
  std::vector<Wall> walls;
  std::vector<std::string> unknown_walls;  ///< those that are left out, since a snapshot does not say where they are
  std::int64_t step = 0;
  double time = 0.0;  ///< s
};

/// The deck that the file was written with, or in its place another: the text of a deck, its path and texts
/// "key=value".
struct DeckSource {
  std::string text;  ///< empty: that in the file
  std::string path;
  std::vector<std::string> overrides;
};

/// From the bytes of a snapshot or a checkpoint. A checkpoint says where its walls are; with a snapshot those that rest
/// and are there in all phases count, and which grains are held follows from the blocks of the deck. The files that it
/// names are read by `read_file`. FileError, beginning with `file`, for anything else; DeckError where the deck does
/// not fit.
State read_state(const std::string& bytes, const std::string& file, const DeckSource& deck, const ReadFile& read_file);

}  // namespace repose::fields
